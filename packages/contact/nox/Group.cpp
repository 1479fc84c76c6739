#include "contact/nox/Group.hpp"

#include "contact/solve/Descent.hpp"
#include "contact/solve/NewtonStep.hpp"

namespace epafi::contact {

namespace {

void assign(NOX::LAPACK::Vector& to, const Vector& from) {
  for (std::size_t i = 0; i < from.size(); ++i)
    to(static_cast<int>(i)) = from[i];
}

Teuchos::RCP<NOX::LAPACK::Vector> zeros(int size) {
  auto result = Teuchos::rcp(new NOX::LAPACK::Vector(size));
  result->init(0);
  return result;
}

}  // namespace

Vector numbers(const NOX::Abstract::Vector& v) {
  const auto& dense = dynamic_cast<const NOX::LAPACK::Vector&>(v);
  Vector result;
  result.reserve(static_cast<std::size_t>(dense.length()));
  for (int i = 0; i < static_cast<int>(dense.length()); ++i)
    result.push_back(dense(i));
  return result;
}

Group::Group(const Equation& equation, NewtonMethod method, const Vector& start)
    : equation_(&equation),
      method_(method),
      x_(zeros(static_cast<int>(start.size()))),
      f_(zeros(static_cast<int>(start.size()))),
      newton_(zeros(static_cast<int>(start.size()))),
      gradient_(zeros(static_cast<int>(start.size()))) {
  assign(*x_, start);
}

Group::Group(const Group& other, NOX::CopyType type)
    : equation_(other.equation_),
      method_(other.method_),
      x_(Teuchos::rcp(new DenseVector(*other.x_, type))),
      f_(Teuchos::rcp(new DenseVector(*other.f_, type))),
      newton_(Teuchos::rcp(new DenseVector(*other.newton_, type))),
      gradient_(Teuchos::rcp(new DenseVector(*other.gradient_, type))) {
  if (type == NOX::DeepCopy)
    *this = other;
}

Teuchos::RCP<NOX::Abstract::Group> Group::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new Group(*this, type));
}

Group& Group::operator=(const NOX::Abstract::Group& source) {
  return *this = dynamic_cast<const Group&>(source);
}

Group& Group::operator=(const Group& other) {
  if (&other == this)
    return *this;
  equation_ = other.equation_;
  method_ = other.method_;
  *x_ = *other.x_;
  *f_ = *other.f_;
  *newton_ = *other.newton_;
  *gradient_ = *other.gradient_;
  evaluation_ = other.evaluation_;
  hasJacobian_ = other.hasJacobian_;
  hasNewton_ = other.hasNewton_;
  hasGradient_ = other.hasGradient_;
  return *this;
}

void Group::forget() {
  evaluation_ = nullptr;
  hasJacobian_ = hasNewton_ = hasGradient_ = false;
}

void Group::setX(const NOX::Abstract::Vector& x) {
  *x_ = dynamic_cast<const DenseVector&>(x);
  forget();
}

void Group::computeX(const NOX::Abstract::Group& from,
                     const NOX::Abstract::Vector& direction, double step) {
  const auto& origin = dynamic_cast<const Group&>(from);
  x_->update(1, *origin.x_, step, direction);
  forget();
}

Group::ReturnType Group::computeF() {
  if (!isF()) {
    evaluation_ = std::make_shared<const Evaluation>(equation_->at(numbers(*x_)));
    assign(*f_, evaluation_->residual);
  }
  return Ok;
}

Group::ReturnType Group::computeJacobian() {
  hasJacobian_ = true;  // its rows come with the residual
  return computeF();
}

Group::ReturnType Group::computeGradient() {
  computeF();
  assign(*gradient_, equation_->meritGradient(*evaluation_));
  hasGradient_ = true;
  return Ok;
}

Group::ReturnType Group::computeNewton(Teuchos::ParameterList&) {
  if (hasNewton_)
    return Ok;
  if (!isF())
    return BadDependency;
  assign(*newton_, direction());
  hasNewton_ = true;
  return Ok;
}

Vector Group::direction() const {
  return method_ == NewtonMethod::MeritDescent
             ? meritDescentStep(*equation_, *evaluation_)
             : newtonStep(*equation_, *evaluation_);
}

Group::ReturnType Group::applyJacobian(const NOX::Abstract::Vector& input,
                                       NOX::Abstract::Vector& result) const {
  if (!isF())
    return BadDependency;
  assign(dynamic_cast<DenseVector&>(result),
         equation_->jacobianTimes(*evaluation_, numbers(input)));
  return Ok;
}

}  // namespace epafi::contact
