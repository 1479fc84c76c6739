#include "contact/nox/Merit.hpp"

#include "contact/nox/Group.hpp"

#include <stdexcept>

namespace epafi::contact {

namespace {

const Group& ours(const NOX::Abstract::Group& group) {
  return dynamic_cast<const Group&>(group);
}

Evaluation evaluate(const Group& group) {
  return group.isF() ? group.evaluation() : group.equation().at(numbers(group.getX()));
}

}  // namespace

double Merit::computef(const NOX::Abstract::Group& group) const {
  return ours(group).equation().merit(evaluate(ours(group)));
}

void Merit::computeGradient(const NOX::Abstract::Group& group,
                            NOX::Abstract::Vector& result) const {
  const Vector gradient = ours(group).equation().meritGradient(evaluate(ours(group)));
  auto& dense = dynamic_cast<NOX::LAPACK::Vector&>(result);
  for (std::size_t i = 0; i < gradient.size(); ++i)
    dense(static_cast<int>(i)) = gradient[i];
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
