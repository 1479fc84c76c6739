#pragma once

#include "contact/problem/Problem.hpp"

#include <functional>

namespace epafi::contact {

/// Result of followOffset().
struct OffsetPath {
  Vector unknowns;       ///< x = (λ, α) at the end; empty if not finite
  int pivots = 0;        ///< changes of one state or of one linear piece of a bound
  bool arrived = false;  ///< did it reach t = 0?
};

/// Floating point operations of one pivot with n coefficients.
inline double workOfPivot(Index n) {
  return 2 * static_cast<double>(n) * static_cast<double>(n);
}

/// Called with the number of pivots and its limit, at the start and then every 10⁹
/// operations; an exception ends the path.
using OffsetWatch = std::function<void(int pivots, int mostPivots)>;

/// Solves a problem by complementary pivoting; no start value is needed.        [Lemke 1965]
///
/// For the offset d₀ + t v with t large, all contacts are open and all tangential
/// coefficients with s(0) > 0 slip forwards.  The path of solutions is followed to t =
/// 0.  It is linear in t between changes of states or of linear pieces of bounds; at a
/// fold, t changes its direction. If D is definite, the path ends at t = 0 only, for
/// constant bounds and for Coulomb's law
/// with any coefficient.                      [Cottle, Pang, Stone 1992; Stewart, Trinkle 1996]
///
/// Bounds that are not piecewise linear are replaced by tangents, relative error 1e-3.
/// Free rigid motions get springs with rest position `placement`, 1e5 times as soft as D,
/// in addition to their own.  Newton's method removes both errors.
///
/// A pivot takes 2 n² operations, n pivots as many as three LU factorisations.
/// \param placement   α at which the additional springs have no force
/// \param direction   chooses v; rounding errors end one path in a few thousand
/// \param mostPivots  limit of pivots
/// \param watch       may be empty
/// \pre problem.flexibility.isFormed(); Φ is linear, see Equation::withTangent
OffsetPath followOffset(const Problem& problem, const Vector& placement, int direction,
                        int mostPivots, const OffsetWatch& watch = {});

}  // namespace epafi::contact
