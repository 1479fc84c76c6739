#include "contact/coulomb/CoulombOneStep.hpp"

#include "contact/coulomb/CoulombCourse.hpp"

namespace epafi::contact {

namespace {

void fullSteps(CoulombCourse& course, Stage stage) {
  course.steps(stage, std::max(course.run(), course.options().maximumIterations));
}

constexpr PlannedStage<CoulombCourse> oneStepPlan[] = {
    {Stage::FullSteps, CoulombCourse::always, fullSteps},
    {Stage::FollowFriction, CoulombCourse::always, CoulombCourse::followFriction},
    {Stage::MeritDescent, CoulombCourse::always, CoulombCourse::meritDescent},
    {Stage::FixedPoint, CoulombCourse::always, CoulombCourse::updates},
};

}  // namespace

Solution CoulombOneStep::solveSound(const Problem& problem, const State& start) const {
  return follow(oneStepPlan, CoulombCourse(problem, start, tresca_,
                                           Equation::Bound::Lagged, options_));
}

}  // namespace epafi::contact
