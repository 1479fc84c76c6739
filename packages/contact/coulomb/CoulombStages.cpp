#include "contact/coulomb/CoulombStages.hpp"

#include "contact/coulomb/CoulombFixedPoint.hpp"

#include <algorithm>

namespace epafi::contact {

void CoulombCourse::descend(Stage stage, int most) {
  const Equation smooth(problem(), fischerBurmeister(), Equation::Bound::Differentiated,
                        tresca().options().tolerance);
  const NewtonRun run =
      tresca().newton().run(smooth, best(), NewtonMethod::MeritDescent, most);
  Report report = extended({}, stage, run, problem());
  report.coulombIterations = run.iterations;
  add({unpack(problem(), run.best), std::move(report)});
}

void CoulombCourse::meritDescent(CoulombCourse& course, Stage stage) {
  course.descend(stage, 2 * course.run());
}

void CoulombCourse::descendBriefly(CoulombCourse& course, Stage stage) {
  course.descend(stage, std::min(brief, course.run()));
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
