#pragma once

#include "contact/nox/Merit.hpp"

#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

namespace epafi::contact {

/// Armijo's rule:   Ψ(x + t d) <= Ψ(x) + 1e-4 t Ψ'(x)·d,   t = 1, 1/2, 1/4, ...
///
/// up to rounding
class ArmijoSearch final : public NOX::LineSearch::Generic {
 public:
  explicit ArmijoSearch(Teuchos::RCP<const Merit> merit) : merit_(std::move(merit)) {}

  /// False, and step 0, if no t down to 2^-40 will do.
  bool compute(NOX::Abstract::Group& group, double& step,
               const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

 private:
  Teuchos::RCP<const Merit> merit_;
};

/// What NOX wants in its place.
class ArmijoFactory final : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit ArmijoFactory(Teuchos::RCP<const Merit> merit) : merit_(std::move(merit)) {}

  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(
      const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new ArmijoSearch(merit_));
  }

 private:
  Teuchos::RCP<const Merit> merit_;
};

}  // namespace epafi::contact
