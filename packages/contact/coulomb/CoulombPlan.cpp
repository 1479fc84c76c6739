#include "contact/coulomb/CoulombPlan.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

/// A course of Newton's method on Coulomb's problem, every step of which updates the bound.
class CoulombCourse : public NewtonCourse {
 public:
  CoulombCourse(const Problem& problem, const State& start, const Tresca& tresca,
                Equation::Bound bound, CoulombOptions options)
      : NewtonCourse(problem, start, tresca, bound), options_(std::move(options)) {}

  const CoulombOptions& options() const { return options_; }
  bool isCoupled() const { return problem().boundsAreCoupled(); }
  static bool always(const CoulombCourse&) { return true; }

 private:
  CoulombOptions options_;
};

Solution byNewton(const Problem& problem, const State& start, const Tresca& tresca,
                  const CoulombOptions& options);

bool isCoupled(const CoulombCourse& course) { return course.isCoupled(); }

// From zero, coupled bounds are uncoupled first.
bool startsAfar(const CoulombCourse& course) {
  return !course.knowsSets() && (!course.isCoupled() || course.hasStart());
}

bool knowsSets(const CoulombCourse& course) { return course.knowsSets(); }

void fullSteps(CoulombCourse& course, Stage stage) { course.steps(stage, course.run()); }

void stepsOfUpdates(CoulombCourse& course, Stage stage) {
  course.steps(stage, std::max(course.run(), course.options().maximumIterations));
}

void pivoting(CoulombCourse& course, Stage stage) {
  course.pivoting(stage, course.equation(), course.best());
}

void followOffset(CoulombCourse& course, Stage stage) { course.followOffset(stage); }

// Bounds that follow all pressures of an element make active sets wander from afar; bounds
// that follow their own pressure alone do not, and bring near.  Sweeps from there would
// lead away again.
void uncoupled(CoulombCourse& course, Stage stage) {
  const Problem single = withUncoupledBounds(course.problem());
  Solution near = byNewton(single, course.start(), course.tresca(), course.options());
  near.report = asOne(std::move(near.report), stage);
  near.report.coulombIterations = near.report.newtonIterations;
  near.report.status = Status::NotConverged;
  course.add(std::move(near));
}

constexpr PlannedStage<CoulombCourse> newtonPlan[] = {
    {Stage::FullSteps, startsAfar, fullSteps},
    {Stage::Pivoting, knowsSets, pivoting},
    {Stage::Uncoupled, isCoupled, uncoupled},
    {Stage::FullSteps, isCoupled, fullSteps},
    {Stage::FollowOffset, CoulombCourse::always, followOffset},
};

constexpr PlannedStage<CoulombCourse> oneStepPlan[] = {
    {Stage::FullSteps, CoulombCourse::always, stepsOfUpdates},
    {Stage::FollowOffset, CoulombCourse::always, followOffset},
};

Solution byNewton(const Problem& problem, const State& start, const Tresca& tresca,
                  const CoulombOptions& options) {
  return follow(newtonPlan, CoulombCourse(problem, start, tresca,
                                          Equation::Bound::Differentiated, options));
}

}  // namespace

Solution CoulombNewton::solveSound(const Problem& problem, const State& start) const {
  return byNewton(problem, start, tresca_, options_);
}

Solution CoulombOneStep::solveSound(const Problem& problem, const State& start) const {
  return follow(oneStepPlan, CoulombCourse(problem, start, tresca_,
                                           Equation::Bound::Lagged, options_));
}

}  // namespace epafi::contact
