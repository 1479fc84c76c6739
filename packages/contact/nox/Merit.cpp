#include "contact/nox/Merit.hpp"

#include "contact/equation/SmoothMerit.hpp"
#include "contact/nox/ContactJacobian.hpp"
#include "contact/nox/StepDirection.hpp"

#include <NOX_Abstract_Group.H>

#include <stdexcept>

namespace epafi::contact {

double Merit::computef(const NOX::Abstract::Group& group) const {
  const auto point = pointOf(*model_, group);
  return merit(point->equation(), point->evaluation());
}

void Merit::computeGradient(const NOX::Abstract::Group& group,
                            NOX::Abstract::Vector& result) const {
  const auto point = pointOf(*model_, group);
  assign(result, meritGradient(point->equation(), point->evaluation()));
}

double Merit::computeSlope(const NOX::Abstract::Vector& direction,
                           const NOX::Abstract::Group& group) const {
  const auto gradient = direction.clone(NOX::ShapeCopy);
  computeGradient(group, *gradient);
  return gradient->innerProduct(direction);
}

double Merit::computeQuadraticModel(const NOX::Abstract::Vector&,
                                    const NOX::Abstract::Group&) const {
  throw std::logic_error("only trust regions use a quadratic model");
}

void Merit::computeQuadraticMinimizer(const NOX::Abstract::Group&,
                                      NOX::Abstract::Vector&) const {
  throw std::logic_error("only trust regions use a quadratic model");
}

}  // namespace epafi::contact
