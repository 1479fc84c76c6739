#pragma once

#include "contact/solve/ActiveSets.hpp"

#include <NOX_Direction_Generic.H>
#include <NOX_Direction_UserDefinedFactory.H>

namespace epafi::contact {

/// Newton's direction with sets that do not come back for ever, see Pivoting.
class PivotingDirection final : public NOX::Direction::Generic {
 public:
  bool reset(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) override;

  /// \throws bem::NumericalError as newtonStep.
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
               const NOX::Solver::Generic& solver) override;
  using Generic::compute;

 private:
  Pivoting pivoting_;
};

/// What NOX wants in its place.
class PivotingFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  Teuchos::RCP<NOX::Direction::Generic> buildDirection(
      const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new PivotingDirection);
  }
};

}  // namespace epafi::contact
