#include "contact/nox/ArmijoSearch.hpp"

#include "contact/nox/Group.hpp"

#include <NOX_Solver_Generic.H>

#include <limits>

namespace epafi::contact {

bool ArmijoSearch::compute(NOX::Abstract::Group& group, double& step,
                           const NOX::Abstract::Vector& direction,
                           const NOX::Solver::Generic& solver) {
  constexpr double sufficient = 1e-4;
  const auto& from = dynamic_cast<const Group&>(solver.getPreviousSolutionGroup());
  auto& to = dynamic_cast<Group&>(group);
  const double old = merit_->computef(from);
  const double slope = merit_->computeSlope(direction, from);
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * old;

  step = 1;
  for (int halvings = 0; halvings <= 40; ++halvings, step *= 0.5) {
    to.computeX(from, direction, step);
    to.computeF();
    if (step * slope <= rounding &&
        merit_->computef(to) - old <= sufficient * step * slope + rounding)
      return true;
  }
  step = 0;
  to.computeX(from, direction, step);
  return false;
}

}  // namespace epafi::contact
