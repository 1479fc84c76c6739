#include "contact/coulomb/FrictionContinuation.hpp"

#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/Sweeps.hpp"
#include "contact/solve/Advance.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

namespace {

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
Solution correct(const Problem& problem, const State& start, const Tresca& tresca,
                 int patience, int most) {
  NewtonCourse course(problem, start, tresca, Equation::Bound::Differentiated);
  const int steps = std::min(patience, tresca.options().maximumIterations);
  const auto pivot = [&](const Vector& from) {
    course.add(Stage::Pivoting,
               tresca.newton().run(course.sharp(), from, NewtonMethod::Pivoting, steps));
  };
  const Vector from = course.best();
  pivot(from);
  if (!course.report().converged() && course.report().newtonIterations < most)
    pivot(smoothed(course.sharp(), from));
  return std::move(course).solution();
}

}  // namespace

Solution followFriction(const Problem& problem, const Tresca& tresca, int steps,
                        int patience) {
  constexpr Pace pace{0.25, 1, 1.0 / 256};
  ScaledFriction friction(problem);
  Solution begin;
  try {
    NewtonCourse course(friction.at(0), {}, tresca, Equation::Bound::Differentiated);
    course.steps(Stage::FullSteps, std::min(steps, course.run()));
    begin = std::move(course).solution();
  } catch (const bem::NumericalError& error) {
    begin.report = failed(error);  // without friction there is no equilibrium
  }
  if (!begin.report.converged())
    return begin;
  int spent = 0;
  return advance(std::move(begin), pace, steps,
                 [&](double theta, const State& start) {
                   if (spent >= steps)
                     return Solution{start, {}};
                   Solution corrected = correct(friction.at(theta), start, tresca,
                                                patience, steps - spent);
                   spent += corrected.report.newtonIterations;
                   return corrected;
                 })
      .solution;
}

}  // namespace epafi::contact
