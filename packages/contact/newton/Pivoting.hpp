#pragma once

#include "contact/equation/Equation.hpp"

#include <cstddef>
#include <set>

namespace epafi::contact {

/// The set that the rows of an evaluation are linearised by: Newton's next step solves
/// the linear problem that it says.  Rows must be those of the projection.
ActiveSet rowSet(const Evaluation& e);

/// A point's rows linearised by another set: a step with these solves that set's linear
/// problem.
LinearRows holding(const Equation& equation, const Evaluation& e, const ActiveSet& set);

/// Which set each step solves for, so that sets do not come back for ever.
///
/// Newton's method takes over all coefficients that violate their condition.  Where bases
/// of degree two and more share little with a diagonal matrix this overshoots, and sets
/// return (period three with Gauss-Lobatto points).  So: as long as the number of
/// violations falls, take all; where it does not, only those at least half as large as
/// the largest; where such a set returns, the last one alone until the number falls.  The
/// last rule ends after finitely many steps for every matrix with positive principal
/// minors, as Tresca's.       [Murty 1974; Júdice, Pires 1994]
class Pivoting {
 public:
  /// The set for the step from e.  Memory begins anew where e does not solve the last
  /// set's problem, as after a step that places a body.
  ActiveSet next(const Equation& equation, const Evaluation& e);

 private:
  void choose(const Equation& equation, const Evaluation& e, const ActiveSet& wanted);
  void begin(ActiveSet set);

  ActiveSet set_;             // of the last step; empty before the first
  std::size_t fewest_ = 0;    // violations so far
  std::set<ActiveSet> seen_;  // since then
  bool single_ = false;
};

}  // namespace epafi::contact
