#include "contact/nox/PivotingDirection.hpp"

#include "contact/nox/Group.hpp"
#include "contact/solve/NewtonStep.hpp"

namespace epafi::contact {

bool PivotingDirection::reset(const Teuchos::RCP<NOX::GlobalData>&,
                              Teuchos::ParameterList&) {
  pivoting_ = {};
  return true;
}

bool PivotingDirection::compute(NOX::Abstract::Vector& direction,
                                NOX::Abstract::Group& group,
                                const NOX::Solver::Generic&) {
  if (group.computeF() != NOX::Abstract::Group::Ok)
    return false;
  const auto& ours = dynamic_cast<const Group&>(group);
  const Equation& equation = ours.equation();
  const Evaluation& e = ours.evaluation();
  const Vector step =
      newtonStep(equation, holding(equation, e, pivoting_.next(equation, e)));
  auto& dense = dynamic_cast<NOX::LAPACK::Vector&>(direction);
  for (std::size_t i = 0; i < step.size(); ++i)
    dense(static_cast<int>(i)) = step[i];
  return true;
}

}  // namespace epafi::contact
