#include "contact/nox/ArmijoSearch.hpp"

#include "contact/nox/Group.hpp"

#include <NOX_Solver_Generic.H>

namespace epafi::contact {

bool ArmijoSearch::compute(NOX::Abstract::Group& group, double& step,
                           const NOX::Abstract::Vector& direction,
                           const NOX::Solver::Generic& solver) {
  constexpr double sufficient = 1e-4;
  const auto& from = dynamic_cast<const Group&>(solver.getPreviousSolutionGroup());
  auto& to = dynamic_cast<Group&>(group);
  const auto moved = direction.clone(NOX::ShapeCopy);

  step = 1;
  for (int halvings = 0; halvings <= 40; ++halvings, step *= 0.5) {
    to.computeX(from, direction, step);
    to.computeF();
    moved->update(1, to.getX(), -1, from.getX(), 0);
    const double slope = merit_->computeSlope(*moved, from);
    const double slack = merit_->rounding(from, to);
    if (merit_->change(from, to) <= sufficient * slope + slack && slope <= slack)
      return true;
  }
  step = 0;
  to.computeX(from, direction, step);
  return false;
}

}  // namespace epafi::contact
