#include "contact/coulomb/CoulombStages.hpp"

#include "contact/coulomb/CoulombFixedPoint.hpp"
#include "contact/coulomb/FrictionContinuation.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

/// Has a path ended without friction?
bool hasNoBeginning(const std::vector<StageRun>& stages) {
  return std::any_of(stages.begin(), stages.end(), [](const StageRun& run) {
    return (run.stage == Stage::FollowFriction && run.parts.size() < 2) ||
           hasNoBeginning(run.parts);
  });
}

}  // namespace

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
  return !hasNoBeginning(course.report().stages);
}

void CoulombCourse::update(Stage stage, int most) {
  const CoulombFixedPoint fixedPoint(tresca(), options());
  Solution solution =
      fixedPoint.updates(problem(), unpack(problem(), best()), std::min(most, left()));
  solution.report = asOne(std::move(solution.report), stage);
  add(std::move(solution));
}

void CoulombCourse::updates(CoulombCourse& course, Stage stage) {
  course.update(stage, course.left());
}

void CoulombCourse::updateBriefly(CoulombCourse& course, Stage stage) {
  course.update(stage, brief);
}

}  // namespace epafi::contact
