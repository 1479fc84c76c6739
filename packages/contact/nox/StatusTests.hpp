#pragma once

#include "contact/newton/Newton.hpp"
#include "contact/nox/ContactModel.hpp"

#include <NOX_StatusTest_Generic.H>

#include <limits>
#include <map>
#include <vector>

namespace epafi::contact {

/// Status test after each step, which also records the history for a report.
///
/// Converged: the scaled residual is below the tolerance, or a full step with the same active set,
/// which solves a linear problem, does not reduce it, so that it is the rounding error of D.
/// Never because an active set occurs again.
/// Failed: an active set occurs again without a smaller residual (a cycle of active sets), the
/// residual grew by a factor of a million, or it is not a number.
class StepTest final : public NOX::StatusTest::Generic {
 public:
  /// \param patience number of recurring active sets that ends the run
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
