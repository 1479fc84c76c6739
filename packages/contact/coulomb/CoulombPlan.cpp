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
  static bool always(const CoulombCourse&) { return true; }

 private:
  CoulombOptions options_;
};


bool startsAfar(const CoulombCourse& course) { return !course.knowsSets(); }
bool knowsSets(const CoulombCourse& course) { return course.knowsSets(); }

void fullSteps(CoulombCourse& course, Stage stage) { course.steps(stage, course.run()); }

void stepsOfUpdates(CoulombCourse& course, Stage stage) {
  course.steps(stage, std::max(course.run(), course.options().maximumIterations));
}

void pivoting(CoulombCourse& course, Stage stage) {
  course.pivoting(stage, course.equation(), course.best());
}

void followOffset(CoulombCourse& course, Stage stage) { course.followOffset(stage); }

constexpr PlannedStage<CoulombCourse> newtonPlan[] = {
    {Stage::FullSteps, startsAfar, fullSteps},
    {Stage::Pivoting, knowsSets, pivoting},
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
