#pragma once

#include "contact/newton/Newton.hpp"
#include "contact/nox/ContactModel.hpp"

#include <NOX_StatusTest_Generic.H>

#include <limits>
#include <map>
#include <vector>

namespace epafi::contact {

/// Decides after each step whether to go on, and keeps the history that a report needs.
///
/// Converged: by the scaled residual, or where a full step on the same sets, which solves a
/// linear problem, leaves it as it was: then it is what D rounds by. Never because a set of states
/// came back later.
/// Failed: a set came back although the residual has not fallen since (the classical
/// cycle of active sets), the residual grew a million times, or it is no number.
class StepTest final : public NOX::StatusTest::Generic {
 public:
  /// `patience`: how many returning sets end the run.
  StepTest(Teuchos::RCP<const ContactModel> model, int patience)
      : model_(std::move(model)), patience_(patience) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType check) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override;

  /// Everything but the number of iterations and the end of an exhausted run.
  const NewtonRun& history() const { return run_; }

 private:
  void record(const Evaluation& e);

  Teuchos::RCP<const ContactModel> model_;
  int patience_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  NewtonRun run_;
  bool isRounding(const ActiveSet& set, double scaled) const;

  std::vector<ActiveSet> sets_;
  ActiveSet last_;                    ///< that of the step before
  std::map<ActiveSet, double> seen_;  // a set, and the residual when it was last seen
  double first_ = 0;
  double least_ = 0;
  double improved_ = 0;       // the residual at the last real progress
  std::size_t progress_ = 0;  // and the step
  int settling_ = std::numeric_limits<int>::max();  // fewest changes of a step
};

}  // namespace epafi::contact
