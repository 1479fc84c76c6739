#pragma once

#include "contact/nox/ContactModel.hpp"

#include <NOX_MeritFunction_Generic.H>

namespace epafi::contact {

/// Ψ = ½ |F|² with the Fischer-Burmeister function, the merit function of NOX's line
/// searches.
///
/// Ψ is continuously differentiable where the slip bound is; ½ |F|² of Equation is not.
///                                                       [De Luca, Facchinei, Kanzow 1996]
class Merit final : public NOX::MeritFunction::Generic {
 public:
  explicit Merit(Teuchos::RCP<const ContactModel> model) : model_(std::move(model)) {}

  double computef(const NOX::Abstract::Group& group) const override;
  void computeGradient(const NOX::Abstract::Group& group,
                       NOX::Abstract::Vector& result) const override;
  double computeSlope(const NOX::Abstract::Vector& direction,
                      const NOX::Abstract::Group& group) const override;
  /// Only trust regions use a quadratic model.
  /// \throws std::logic_error
  double computeQuadraticModel(const NOX::Abstract::Vector& direction,
                               const NOX::Abstract::Group& group) const override;
  void computeQuadraticMinimizer(const NOX::Abstract::Group& group,
                                 NOX::Abstract::Vector& result) const override;
  const std::string& name() const override { return name_; }

 private:
  Teuchos::RCP<const ContactModel> model_;
  std::string name_ = "half the squared Fischer-Burmeister residual";
};

}  // namespace epafi::contact
