#pragma once

#include <string>
#include <vector>

namespace epafi::contact {

/// How much shear a contact point carries:  |λₜ| ≤ s(λₙ).
///
/// `strength` is the value at the point of the expression that the scene gives for the
/// law: a threshold [stress] under Tresca, a coefficient [-] under Coulomb.  Bounds are
/// proportional to it and, where they depend on it, to the pressure's positive part.
struct FrictionLaw {
  const char* name;
  const char* parameter;  ///< the scene's key of the strength; empty if the law has none
  const char* meaning;
  bool dependsOnPressure;
  bool strengthIsStress;
  double (*slipBound)(double pressure, double strength);
  /// Derivative of slipBound by the pressure.
  double (*slipBoundSlope)(double pressure, double strength);
};

/// All laws.  A new one is one line in FrictionLaw.cpp.
const std::vector<FrictionLaw>& frictionLaws();

/// \throws bem::InputError naming the known laws.
const FrictionLaw& frictionLaw(const std::string& name);

}  // namespace epafi::contact
