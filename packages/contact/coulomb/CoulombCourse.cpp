#include "contact/coulomb/CoulombCourse.hpp"

#include "contact/coulomb/CoulombFixedPoint.hpp"
#include "contact/coulomb/FrictionContinuation.hpp"

namespace epafi::contact {

void CoulombCourse::followFriction(CoulombCourse& course, Stage stage) {
  Solution solution =
      contact::followFriction(course.problem(), course.tresca(), course.left());
  solution.report = asOne(std::move(solution.report), stage);
  solution.report.coulombIterations = solution.report.newtonIterations;
  course.globalise();
  course.add(std::move(solution));
}

void CoulombCourse::meritDescent(CoulombCourse& course, Stage stage) {
  const Problem& problem = course.problem();
  const Equation smooth(problem, fischerBurmeister(), Equation::Bound::Differentiated,
                        course.tresca().options().tolerance);
  const NewtonRun run = course.tresca().newton().run(
      smooth, course.best(), NewtonMethod::MeritDescent, 2 * course.run());
  Report report = extended({}, stage, run, problem);
  report.coulombIterations = run.iterations;
  course.add({unpack(problem, run.best), std::move(report)});
}

void CoulombCourse::updates(CoulombCourse& course, Stage stage) {
  const CoulombFixedPoint fixedPoint(course.tresca(), course.options());
  Solution solution = fixedPoint.updates(
      course.problem(), unpack(course.problem(), course.best()), course.left());
  solution.report = asOne(std::move(solution.report), stage);
  course.add(std::move(solution));
}

}  // namespace epafi::contact
