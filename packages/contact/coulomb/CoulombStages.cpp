#include "contact/coulomb/CoulombStages.hpp"

#include "contact/coulomb/CoulombFixedPoint.hpp"

#include <algorithm>

namespace epafi::contact {

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
