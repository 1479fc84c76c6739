#pragma once

#include "bem/operators/Laplace.hpp"
#include "contact/conditions/Conditions.hpp"
#include "contact/conditions/PlaneHeat.hpp"

namespace epafi::contact {

/// Steady heat conduction in a body: factored Laplace operators on its mesh, for boundary
/// temperatures and fluxes that change with time.
class Conduction {
 public:
  /// \param kinds boundaries with given temperature, at least one
  /// \throws InputError if there are too many unknowns for dense operators
  Conduction(const bem::Mesh& mesh, const ThermalConditions& kinds);

  /// \throws InputError if temperatures of adjacent boundaries differ at the common vertex
  std::shared_ptr<const ConductedHeat> heat(const ThermalConditions& now) const;

  /// Flows that a body can have, and those on a mesh: one for each degree of an element.
  static constexpr bem::Index largestSize = 4000;
  static bem::Index sizeOn(const bem::Mesh& mesh);

 private:
  bem::Space space_;
  bem::MixedLaplace laplace_;
  PlaneHeat::Places places_;
};

}  // namespace epafi::contact
