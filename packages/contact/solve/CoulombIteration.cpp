#include "contact/solve/CoulombIteration.hpp"

#include "contact/solve/CoulombFixedPoint.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

/// Newton's method on the coupled problem, the derivative of the slip bound included.
class CoulombNewton final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override {
    return solver_.solveSound(problem, start);
  }
};

/// One Newton step per update of the slip bound.                             [P sec. 7]
class CoulombOneStep final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override {
    return solver_.inStages(
        problem, start, Equation::Bound::Lagged,
        std::max(solver_.options().maximumIterations, options_.maximumIterations));
  }
};

template <class Solver>
std::unique_ptr<NonlinearSolver> make(const ContactSolver& solver,
                                      const CoulombOptions& options) {
  return std::make_unique<Solver>(solver, options);
}

}  // namespace

bem::Family<CoulombIteration>& coulombIterations() {
  static bem::Family<CoulombIteration> family(
      "Coulomb iteration",
      {
          {"Newton", "the friction bound is differentiated too", make<CoulombNewton>},
          {"Inexact Fixed Point", "one Newton step per update of the bound",
           make<CoulombOneStep>},
          {"Fixed Point", "a whole Tresca problem per update", make<CoulombFixedPoint>},
      });
  return family;
}

std::unique_ptr<NonlinearSolver> makeCoulomb(const ContactSolver& solver,
                                             const CoulombOptions& options) {
  return coulombIterations().at(options.iteration).make(solver, options);
}

void CoulombOptions::keys(bem::Keys& keys) {
  keys.add(&iteration, "Coulomb Iteration", coulombIterations(),
           "how a friction bound that depends on the pressure is found; ");
  keys.add(&tolerance, "Coulomb Tolerance", "1", {0, 1, true, true},
           "change of the friction bound, relative to the load");
  keys.add(&maximumIterations, "Coulomb Maximum Iterations", "1", bem::from(1),
           "updates of the friction bound");
}

}  // namespace epafi::contact
