#include "contact/solve/CoulombIteration.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

/// Fixed point iteration: each update of the slip bound solves a Tresca problem; updates are
/// damped if the change of the bound does not decrease.
class CoulombFixedPoint final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;
  Solution updates(const Problem& problem, const State& start) const;
  Solution firstBound(const Problem& problem, const State& start) const;
  /// What solves the problem of an update.
  ContactSolver tresca() const;
};

constexpr double smallestDamping = 1.0 / 64;

double largestDifference(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i])  // both are infinite where sides are bonded
      largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// A bound to begin with: that of the start or, where it is zero and friction may have to
// hold the body, that after a few steps of the coupled problem: the load comes from body to body.
Solution CoulombFixedPoint::firstBound(const Problem& problem, const State& start) const {
  const int steps = static_cast<int>(std::max<Index>(5, problem.rigidMotions()));
  const Vector bounds = problem.slipBounds(start.multiplier);
  const bool slippery = std::all_of(bounds.begin(), bounds.end(), [](double s) {
    return s <= 0 || !std::isfinite(s);  // infinite where sides are bonded
  });
  if (problem.rigidMotions() == 0 || !slippery)
    return {start, {}};
  const NewtonRun run = solver_.newton().run(
      Equation(problem, Equation::Bound::Lagged, solver_.options().tolerance),
      pack(problem, start), steps);
  return {unpack(problem, run.last), extended({}, Stage::NearStart, run, problem)};
}

ContactSolver CoulombFixedPoint::tresca() const {
  const TrescaOptions& own = options().tresca;
  ContactSolverOptions inner = solver_.options();
  inner.tolerance = own.tolerance.value_or(inner.tolerance);
  inner.maximumIterations = own.maximumIterations.value_or(inner.maximumIterations);
  return ContactSolver(solver_.newton(), inner, solver_.watch());
}

// One update of the bound: Tresca's problem, its report added to what came before.
Solution updated(const ContactSolver& solver, const Problem& tresca, Solution before) {
  Report& report = before.report;
  report.coulombIterations += 1;
  try {
    Solution next = solver.solveSound(tresca, before.state);
    next.report = joined(std::move(next.report), report);
    return next;
  } catch (const bem::NumericalError& error) {
    // With this bound there is no equilibrium; with the right one there may be.
    report.status = Status::NotConverged;
    report.failure = error.what();
    report.stages.push_back({Stage::FullSteps, 0, 0, End::NoBalance});
    return before;
  }
}

Solution CoulombFixedPoint::updates(const Problem& problem, const State& start) const {
  const ContactSolver solver = tresca();
  const double tolerance = std::max(solver.options().tolerance, options().tolerance);
  const Equation coulomb(problem, Equation::Bound::Lagged, tolerance);
  Solution solution = firstBound(problem, start);
  Vector bounds = problem.slipBounds(solution.state.multiplier);
  double damping = 1;
  double change = 0;
  for (int k = 1; k <= options().maximumIterations; ++k) {
    solution = updated(solver, withSlipBounds(problem, bounds), std::move(solution));

    const Evaluation e = coulomb.at(pack(problem, solution.state));
    const double previous =
        std::exchange(change, largestDifference(e.bounds, bounds) / problem.stress);
    Report& result = solution.report;
    result.residual = e.scaled;
    result.tolerance = e.tolerance;
    if (!result.converged() || (e.converged && change <= e.tolerance))
      return solution;
    if (k > 2 && change > 0.95 * previous)
      damping = std::max(0.5 * damping, smallestDamping);
    for (std::size_t t = 0; t < bounds.size(); ++t)
      if (e.bounds[t] != bounds[t])
        bounds[t] += damping * (e.bounds[t] - bounds[t]);
  }
  solution.report.status = Status::NotConverged;
  solution.report.stages.push_back({Stage::FixedPoint, 0, change, End::Unsettled});
  return solution;
}

Solution CoulombFixedPoint::solveSound(const Problem& problem, const State& start) const {
  Solution solution = updates(problem, unpack(problem, pack(problem, start)));
  solution.report = asOne(std::move(solution.report), Stage::FixedPoint);
  return solution;
}

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
        std::max(solver_.options().maximumIterations, options().maximumIterations));
  }
};

template <class Solver>
std::unique_ptr<CoulombSolver> make(const ContactSolver& solver,
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

void CoulombSolver::setParameterList(const Teuchos::RCP<Teuchos::ParameterList>& list) {
  const std::string iteration = options().iteration;
  Acceptor::setParameterList(list);
  if (options().iteration != iteration)
    throw bem::InputError(list->name(), "->Coulomb Iteration = '", options().iteration,
                          "', but the solver is made for '", iteration, "'");
}

std::unique_ptr<CoulombSolver> makeCoulomb(const ContactSolver& solver,
                                           const CoulombOptions& options) {
  return coulombIterations().at(options.iteration).make(solver, options);
}

std::unique_ptr<CoulombSolver> coulombFromList(
    const ContactSolver& solver, const Teuchos::RCP<Teuchos::ParameterList>& list) {
  CoulombOptions options;
  bem::accept(options, *list);
  auto result = makeCoulomb(solver, options);
  result->setParameterList(list);
  return result;
}

void TrescaOptions::keys(bem::Keys& keys) {
  keys.add(&tolerance, "Tolerance", "1", {0, 1, true, true},
           "residual, relative to the load; without it, that of the whole");
  keys.add(&maximumIterations, "Maximum Iterations", "1", bem::from(1),
           "Newton steps of one run; without it, those of the whole");
}

void CoulombOptions::keys(bem::Keys& keys) {
  keys.add(&iteration, "Coulomb Iteration", coulombIterations(),
           "how a friction bound that depends on the pressure is found; ");
  keys.add(&tolerance, "Coulomb Tolerance", "1", {0, 1, true, true},
           "change of the friction bound, relative to the load");
  keys.add(&maximumIterations, "Coulomb Maximum Iterations", "1", bem::from(1),
           "updates of the friction bound");
  keys.add(&tresca, bem::Row("Tresca", bem::Kind::List,
                             "how Fixed Point solves the problem of each update"));
}

}  // namespace epafi::contact
