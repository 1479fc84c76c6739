#pragma once

#include "contact/body/Loads.hpp"
#include "contact/opposite/TraceCoupling.hpp"

#include <vector>

namespace epafi::contact {

/// How a body is held: by clamps, by Fix, or not at all.  The same at all times of a path.
///
/// Columns of `allowed`: the rigid motions that clamps allow, first those fixed by Fix, then
/// the free ones.  `functionals` is the dual basis: functional k of motion l is δ_kl; those of
/// fixed motions are  ∫ u · r ds  for the modes of Fix.
struct Holding {
  std::vector<char> clamped;  ///< see prescribed
  RigidModes modes;
  Matrix allowed{};      ///< displacements x (fixed + free)
  Matrix functionals{};  ///< displacements x (fixed + free)
  std::vector<int>
      fixedModes{};  ///< which of x (0), y (1), rotation (2) Fix holds, in order

  /// Factors of the motions for which ∫ u · r ds is the dual functional: 1, but on a body of
  /// diameter d < 1 entries of motions grow like 1/d or 1/d², and rounding errors of A⁻¹ like their
  /// square: there each motion has the largest entry 1.
  Vector scales{};

  Index fixed() const { return static_cast<Index>(fixedModes.size()); }
  Index free() const { return allowed.columns() - fixed(); }
};

/// \throws bem::InputError if clamps already prevent a mode of Fix
Holding makeHolding(const bem::Space& space, const Conditions& conditions);

/// C r on all multipliers, of the allowed motions r from number `first` on; zero where that
/// is rounding.  It is B r, too, as the traction of a rigid motion is zero.
std::vector<Vector> motionsOnContacts(const Holding& holding, Index first,
                                      const TraceCoupling& trace);

}  // namespace epafi::contact
