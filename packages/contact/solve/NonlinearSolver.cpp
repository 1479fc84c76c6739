#include "contact/solve/NonlinearSolver.hpp"

#include "contact/equation/Equilibrium.hpp"

namespace epafi::contact {

Solution NonlinearSolver::solve(const Problem& problem, const State& start) const {
  problem.check();
  requireEquilibrium(problem);
  return solveSound(problem, start);
}

}  // namespace epafi::contact
