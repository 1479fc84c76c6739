#include "contact/nox/Merit.hpp"

#include "contact/equation/SmoothMerit.hpp"
#include "contact/nox/ContactJacobian.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Thyra_Vector.H>

#include <stdexcept>

namespace epafi::contact {

double Merit::computef(const NOX::Abstract::Group& group) const {
  const auto point = model_->at(group);
  return merit(point->equation(), point->evaluation());
}

void Merit::computeGradient(const NOX::Abstract::Group& group,
                            NOX::Abstract::Vector& result) const {
  const auto point = model_->at(group);
  auto& vector = dynamic_cast<NOX::Thyra::Vector&>(result).getThyraVector();
  scatter(dynamic_cast<const SpmdSpace&>(*vector.space()),
          meritGradient(point->equation(), point->evaluation()), 1, 0, vector);
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
