#pragma once

#include "bem/compressed/Laplace.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/conditions/PlaneHeat.hpp"

namespace epafi::contact {

/// Steady heat conduction in a body: factored compressed Laplace operators on its mesh, for
/// boundary temperatures and fluxes that change with time.
class Conduction {
 public:
  /// \param kinds boundaries with given temperature, at least one
  Conduction(const bem::Mesh& mesh, const ThermalConditions& kinds);

  /// \throws InputError if temperatures of adjacent boundaries differ at the common vertex
  std::shared_ptr<const ConductedHeat> heat(const ThermalConditions& now) const;

 private:
  bem::Space space_;
  bem::MixedLaplace laplace_;
  PlaneHeat::Places places_;
};

}  // namespace epafi::contact
