#include "contact/coulomb/FrictionContinuation.hpp"

#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/Sweeps.hpp"
#include "contact/tresca/Tresca.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

namespace {

constexpr double firstStep = 0.25;
constexpr double smallestStep = 1.0 / 256;

// The problem with another law's strength; everything else is copied once.
class ScaledFriction {
 public:
  explicit ScaledFriction(const Problem& problem)
      : original_(problem.tangentials),
        load_(problem.rigidLoad),
        rest_(loadOfFriction(problem)),
        scaled_(withSlipBounds(problem, problem.slipBounds({}))) {}

  const Problem& at(double theta) {
    for (std::size_t t = 0; t < original_.size(); ++t)
      scaled_.tangentials[t] = original_[t].scaled(theta);
    for (std::size_t j = 0; j < load_.size(); ++j)
      scaled_.rigidLoad[j] = load_[j] - (1 - theta) * rest_[j];
    return scaled_;
  }

 private:
  const std::vector<Tangential>& original_;
  Vector load_;
  Vector rest_;
  Problem scaled_;
};

// Active sets that do not return, from the state as it is or, if that fails, from one
// that sweeps have settled; where both fail, a shorter step in θ costs less than a line
// search.
Solution correct(const Problem& problem, const State& start,
                 const SolverOptions& options) {
  const Equation sharp(problem, complementarity("Projection"),
                       Equation::Bound::Differentiated, options.tolerance);
  const auto from = [&](const Vector& unknowns) {
    return runNewton(sharp, unknowns, NewtonMethod::Pivoting, options.maximumIterations,
                     options.nox);
  };
  const NewtonRun near = from(pack(problem, start));
  Report report = extended({}, Stage::Pivoting, near, problem);
  if (near.end == End::Converged)
    return {unpack(problem, near.last), std::move(report)};
  const NewtonRun smooth = from(smoothed(sharp, pack(problem, start)));
  return {unpack(problem, smooth.last),
          extended(std::move(report), Stage::Pivoting, smooth, problem)};
}

}  // namespace

Solution followFriction(const Problem& problem, const SolverOptions& options) {
  Solution now;
  ScaledFriction friction(problem);
  try {
    now = solveFixedBounds(friction.at(0), {}, options);
  } catch (const bem::NumericalError& error) {
    now.report.reason = error.what();  // without friction there is no equilibrium
  }
  double theta = 0;
  double step = firstStep;
  while (now.report.status == Status::Converged && theta < 1) {
    const double next = std::min(1.0, theta + step);
    Solution trial = correct(friction.at(next), now.state, options);
    trial.report = joined(std::move(trial.report), now.report);
    if (trial.report.status == Status::Converged) {
      theta = next;
      step *= 1.5;
      now = std::move(trial);
    } else {
      step *= 0.5;
      now.report.newtonIterations = trial.report.newtonIterations;
      now.report.stages = trial.report.stages;
      if (step < smallestStep)
        now.report = std::move(trial.report);
    }
  }
  now.report = asOne(std::move(now.report), Stage::FollowFriction);
  now.report.globalised = true;
  return now;
}

}  // namespace epafi::contact
