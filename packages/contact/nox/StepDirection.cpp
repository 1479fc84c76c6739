#include "contact/nox/StepDirection.hpp"

#include "contact/nox/ContactJacobian.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Thyra_Vector.H>

namespace epafi::contact {

std::shared_ptr<const Linearisation> pointOf(const ContactModel& model,
                                             const NOX::Abstract::Group& group) {
  return model.at(dynamic_cast<const NOX::Thyra::Vector&>(group.getX()).getThyraVector(),
                  {});
}

void assign(NOX::Abstract::Vector& to, const Vector& values) {
  auto& x = dynamic_cast<NOX::Thyra::Vector&>(to).getThyraVector();
  scatter(dynamic_cast<const SpmdSpace&>(*x.space()), values, 1, 0, x);
}

bool StepDirection::compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
                            const NOX::Solver::Generic&) {
  assign(direction, step_(*pointOf(*model_, group)));
  return true;
}

}  // namespace epafi::contact
