#pragma once

#include "contact/nox/Newton.hpp"
#include "contact/solve/Equation.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_LAPACK_Vector.H>

#include <memory>

namespace epafi::contact {

/// The contact equation at one point, as NOX sees it.
///
/// What has been computed travels with copies, so nothing is shared that a line search
/// could spoil.
class Group final : public NOX::Abstract::Group {
 public:
  Group(const Equation& equation, NewtonMethod method, const Vector& start);
  Group(const Group& other, NOX::CopyType type);

  Group& operator=(const Group& other);
  Group& operator=(const NOX::Abstract::Group& source) override;
  ~Group() override = default;
  void setX(const NOX::Abstract::Vector& x) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction,
                double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeGradient() override;
  /// \throws bem::NumericalError as newtonStep.
  ReturnType computeNewton(Teuchos::ParameterList& list) override;
  ReturnType applyJacobian(const NOX::Abstract::Vector& input,
                           NOX::Abstract::Vector& result) const override;

  bool isF() const override { return evaluation_ != nullptr; }
  bool isJacobian() const override { return isF() && hasJacobian_; }
  bool isGradient() const override { return hasGradient_; }
  bool isNewton() const override { return hasNewton_; }

  const NOX::Abstract::Vector& getX() const override { return *x_; }
  const NOX::Abstract::Vector& getF() const override { return *f_; }
  double getNormF() const override { return f_->norm(); }
  const NOX::Abstract::Vector& getGradient() const override { return *gradient_; }
  const NOX::Abstract::Vector& getNewton() const override { return *newton_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override {
    return gradient_;
  }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override {
    return newton_;
  }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;

  const Equation& equation() const { return *equation_; }
  /// \pre isF()
  const Evaluation& evaluation() const { return *evaluation_; }

 private:
  using DenseVector = NOX::LAPACK::Vector;

  void forget();
  Vector direction() const;

  const Equation* equation_;
  NewtonMethod method_;
  Teuchos::RCP<DenseVector> x_;
  Teuchos::RCP<DenseVector> f_;
  Teuchos::RCP<DenseVector> newton_;
  Teuchos::RCP<DenseVector> gradient_;
  std::shared_ptr<const Evaluation> evaluation_;  // immutable: copies may share it
  bool hasJacobian_ = false;
  bool hasNewton_ = false;
  bool hasGradient_ = false;
};

/// The numbers of a vector that came from a Group.
Vector numbers(const NOX::Abstract::Vector& v);

}  // namespace epafi::contact
