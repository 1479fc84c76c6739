#pragma once

#include "contact/nox/ContactModel.hpp"

#include <NOX_Direction_Generic.H>
#include <NOX_Direction_UserDefinedFactory.H>

#include <functional>

namespace epafi::contact {

/// What has been computed at a group's x.
std::shared_ptr<const Linearisation> pointOf(const ContactModel& model,
                                             const NOX::Abstract::Group& group);

/// Entries into a vector of a group's.
void assign(NOX::Abstract::Vector& to, const Vector& values);

/// A step of Epafi's own as a direction of NOX's.
class StepDirection final : public NOX::Direction::Generic {
 public:
  using Step = std::function<Vector(const Linearisation&)>;

  StepDirection(Teuchos::RCP<const ContactModel> model, Step step)
      : model_(std::move(model)), step_(std::move(step)) {}

  bool reset(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) override {
    return true;
  }
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
               const NOX::Solver::Generic& solver) override;
  using Generic::compute;

 private:
  Teuchos::RCP<const ContactModel> model_;
  Step step_;
};

/// What NOX wants in its place.
class StepFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  StepFactory(Teuchos::RCP<const ContactModel> model, StepDirection::Step step)
      : model_(std::move(model)), step_(std::move(step)) {}

  Teuchos::RCP<NOX::Direction::Generic> buildDirection(
      const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new StepDirection(model_, step_));
  }

 private:
  Teuchos::RCP<const ContactModel> model_;
  StepDirection::Step step_;
};

}  // namespace epafi::contact
