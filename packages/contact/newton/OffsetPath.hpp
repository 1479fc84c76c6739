#pragma once

#include "contact/problem/Problem.hpp"

#include <functional>

namespace epafi::contact {

/// Where a path of offsets ended.
struct OffsetPath {
  Vector unknowns;       ///< x = (λ, α); empty where rounding has left no numbers
  int pivots = 0;        ///< changes of a set or of a bound's piece, one at a time
  bool arrived = false;  ///< at the problem's own offset
};

/// Operations of one pivot on n coefficients.
inline double workOfPivot(Index n) {
  return 2 * static_cast<double>(n) * static_cast<double>(n);
}

/// Is told how many pivots of how many a path has made, first at its beginning and then every
/// 10⁹ operations; what it throws ends the path.
using OffsetWatch = std::function<void(int pivots, int mostPivots)>;

/// Solves a problem by complementary pivoting, from no start.                   [Lemke 1965]
///
/// With the offset d₀ + t v and t large enough everything is open, and what slips without
/// pressure slips forwards.  From there the solution is followed to t = 0: it is linear in t
/// between two changes of a set, or of the linear piece that a bound is on, and t turns back
/// where a change says so.  The path goes round folds, on which every other continuation
/// ends: it cannot end but at t = 0, for constant bounds and for Coulomb's law with any
/// coefficient, if D is definite.             [Cottle, Pang, Stone 1992; Stewart, Trinkle 1996]
///
/// A bound that is no polygon of the pressures is replaced by tangents, within 1e-3 of it.
/// Free rigid motions get springs at `placement`, 1e5 times as soft as D, beside those that they
/// have: Newton's method finds the last digits.
///
/// A change takes 2 n² operations, see workOfPivot, n of them as many as three factorisations.
/// \param placement   α, where the springs are without force
/// \param direction   another v for each; one path in a few thousand is ended by rounding
/// \param watch       may be empty
/// \pre problem.flexibility.isFormed(), and Φ is linear, see Equation::withTangent
OffsetPath followOffset(const Problem& problem, const Vector& placement, int direction,
                        int mostPivots, const OffsetWatch& watch = {});

}  // namespace epafi::contact
