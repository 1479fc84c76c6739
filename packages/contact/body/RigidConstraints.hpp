#pragma once

#include "contact/body/Loads.hpp"

namespace epafi::contact {

/// How the body's rigid motions are held: by clamps, by Fix, or not at all.
///
/// Columns of `allowed`: the rigid motions that clamps allow, first those fixed by Fix, then
/// the free ones.  `functionals` is the dual basis: functional k of motion l is δ_kl; those of
/// fixed motions are  ∫ u · r ds  for the modes of Fix.
struct RigidConstraints {
  Matrix allowed;      ///< displacements x (fixed + free)
  Matrix functionals;  ///< displacements x (fixed + free)
  std::vector<int>
      fixedModes;  ///< which of x (0), y (1), rotation (2) Fix holds, in order

  /// Factors of the fixed motions for which ∫ u · r ds is the dual functional: 1, except on small
  /// bodies, see scalePairs.
  Vector scales{};

  double scale(Index k) const { return scales.empty() ? 1 : scales[k]; }
  Index fixed() const { return static_cast<Index>(fixedModes.size()); }
  Index free() const { return allowed.columns() - fixed(); }
};

/// Scales each motion to a largest entry of 1 and its functional inversely.  On a body of
/// diameter d entries grow like 1/d or 1/d², and rounding errors of A⁻¹ like their square.
void scalePairs(RigidConstraints& constraints);

/// \throws bem::InputError if clamps already prevent a mode of Fix
RigidConstraints makeRigidConstraints(const RigidModes& modes, const Loads& loads,
                                      const Conditions::Fix& fix);

/// How a body is loaded and held.
struct Holding {
  Loads loads;
  RigidModes modes;
  RigidConstraints rigid;
  Vector means{};  ///< see meansOf
};

/// \throws bem::InputError, see makeLoads, makeRigidConstraints.
Holding makeHolding(const bem::Space& space, const Conditions& conditions,
                    bem::Units units);

}  // namespace epafi::contact
