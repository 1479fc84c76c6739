#pragma once

#include "contact/conditions/Conditions.hpp"
#include "contact/conditions/ConductedHeat.hpp"

namespace epafi::contact {

/// Steady conduction of heat in a body: Laplace's operators on its mesh, ready for temperatures
/// and flows on the boundary that change with time.
class Conduction {
 public:
  /// The conditions say on which boundaries a temperature is held: on one at least.
  /// \throws InputError if they are too many unknowns for dense operators.
  Conduction(const bem::Mesh& mesh, const ThermalConditions& kinds);

  /// \throws InputError where temperatures of two boundaries do not meet.
  std::shared_ptr<const ConductedHeat> heat(const ThermalConditions& now) const;

  /// Flows that a body can have, and those on a mesh: one for each degree of an element.
  static constexpr bem::Index largestSize = 4000;
  static bem::Index sizeOn(const bem::Mesh& mesh);

 private:
  bem::Space space_;
  bem::MixedLaplace laplace_;
  ConductedHeat::Places places_;
};

}  // namespace epafi::contact
