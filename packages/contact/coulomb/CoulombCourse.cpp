#include "contact/coulomb/CoulombCourse.hpp"

#include "contact/coulomb/CoulombFixedPoint.hpp"
#include "contact/coulomb/FrictionContinuation.hpp"

namespace epafi::contact {

void CoulombCourse::follow(Stage stage, int most, int patience) {
  Solution solution =
      contact::followFriction(problem(), tresca(), std::min(most, left()), patience);
  solution.report = asOne(std::move(solution.report), stage);
  solution.report.coulombIterations = solution.report.newtonIterations;
  globalise();
  add(std::move(solution));
}

void CoulombCourse::descend(Stage stage, int most) {
  const Equation smooth(problem(), fischerBurmeister(), Equation::Bound::Differentiated,
                        tresca().options().tolerance);
  const NewtonRun run =
      tresca().newton().run(smooth, best(), NewtonMethod::MeritDescent, most);
  Report report = extended({}, stage, run, problem());
  report.coulombIterations = run.iterations;
  add({unpack(problem(), run.best), std::move(report)});
}

void CoulombCourse::followFriction(CoulombCourse& course, Stage stage) {
  course.follow(stage, course.left(), course.run());
}

void CoulombCourse::followBriefly(CoulombCourse& course, Stage stage) {
  constexpr int patience = 8;  // corrections that succeed mostly take a few steps
  course.follow(stage, brief, patience);
}

void CoulombCourse::meritDescent(CoulombCourse& course, Stage stage) {
  course.descend(stage, 2 * course.run());
}

void CoulombCourse::descendBriefly(CoulombCourse& course, Stage stage) {
  course.descend(stage, std::min(brief, course.run()));
}

bool CoulombCourse::mayFollow(const CoulombCourse& course) {
  for (const StageRun& run : course.report().stages)
    if (run.stage == Stage::FollowFriction)
      return !run.parts.empty() && run.parts.back().stage != Stage::InteriorPoint;
  return true;
}

void CoulombCourse::updates(CoulombCourse& course, Stage stage) {
  const CoulombFixedPoint fixedPoint(course.tresca(), course.options());
  Solution solution = fixedPoint.updates(
      course.problem(), unpack(course.problem(), course.best()), course.left());
  solution.report = asOne(std::move(solution.report), stage);
  course.add(std::move(solution));
}

}  // namespace epafi::contact
