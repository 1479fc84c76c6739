#include "contact/solve/NonlinearSolver.hpp"

#include "contact/equation/Equilibrium.hpp"

#include <cmath>

namespace epafi::contact {

Solution NonlinearSolver::solve(const Problem& problem, const State& start) const {
  problem.check();
  if (!(problem.stress > 0) || !std::isfinite(problem.stress))
    throw bem::NumericalError("the contact problem's load has no positive, finite size");
  requireEquilibrium(problem);
  return solveSound(problem, start);
}

}  // namespace epafi::contact
