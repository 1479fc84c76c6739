#include "contact/solve/CoulombIteration.hpp"

#include "contact/solve/CoulombFixedPoint.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace epafi::contact {

using bem::Kind;
using bem::Row;

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

bem::SchemaRows coulombRows() {
  const CoulombOptions defaults;
  return {
      Row("Coulomb Iteration", Kind::Text,
          "how a friction bound that depends on the pressure is found; " +
              meanings(coulombIterations()))
          .standard(defaults.iteration)
          .allowed(coulombIterations().names()),
      Row("Coulomb Tolerance", Kind::Real,
          "change of the friction bound, relative to the load")
          .unit("1")
          .standard(defaults.tolerance)
          .range({0, 1, true, true}),
      Row("Coulomb Maximum Iterations", Kind::Whole, "updates of the friction bound")
          .unit("1")
          .standard(defaults.maximumIterations)
          .range(bem::from(1)),
  };
}

CoulombOptions parseCoulomb(const Teuchos::ParameterList& list) {
  return {list.get<std::string>("Coulomb Iteration"),
          list.get<double>("Coulomb Tolerance"),
          list.get<int>("Coulomb Maximum Iterations")};
}

}  // namespace epafi::contact
