#pragma once

#include "contact/body/Loads.hpp"

namespace epafi::contact {

/// How the body's rigid motions are held: by clamps, by Fix, or not at all.
///
/// `allowed` columns are the rigid motions that no clamp stops: first those that Fix
/// holds, then the free ones.  `functionals` pairs with them: functional k of motion l is
/// δ_kl; those of the fixed motions are exactly  ∫ u · r ds  of the modes that Fix names.
struct RigidConstraints {
  Matrix allowed;      ///< displacements x (fixed + free)
  Matrix functionals;  ///< displacements x (fixed + free)
  std::vector<int>
      fixedModes;  ///< which of x (0), y (1), rotation (2) Fix holds, in order

  /// What the fixed motions would have to be multiplied by to pair with ∫ u · r ds itself: 1,
  /// except on bodies that are small among others, whose pairs are scaled.
  Vector scales{};

  double scale(Index k) const { return scales.empty() ? 1 : scales[k]; }
  Index fixed() const { return static_cast<Index>(fixedModes.size()); }
  Index free() const { return allowed.columns() - fixed(); }
};

/// Scales each pair so that the largest entry of its motion is 1: on a body of diameter d it
/// grows like 1/d or 1/d², and what is taken from A⁻¹ again like its square.
void scalePairs(RigidConstraints& constraints);

/// \throws bem::InputError if a mode of Fix is held by clamps already.
RigidConstraints makeRigidConstraints(const RigidModes& modes, const Loads& loads,
                                      const Conditions::Fix& fix);

}  // namespace epafi::contact
