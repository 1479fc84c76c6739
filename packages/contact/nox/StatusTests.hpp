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
/// Converged: the scaled residual is below the tolerance; or it is at most 1e-8 and a
/// full step with the same active set, which solves a linear problem, leaves 0.9 of it,
/// so that it is the rounding error of D. Failed: an active set recurs behind others
/// without a smaller merit (a cycle of active sets), too many steps make no progress, the
/// residual grew by a factor of a million although no surface yields by a curve, or it is not
/// a number.
class StepTest final : public NOX::StatusTest::Generic {
 public:
  /// What ends the run.
  struct Patience {
    int cycles;         ///< recurring active sets
    std::size_t steps;  ///< without progress
  };
  StepTest(Teuchos::RCP<const ContactModel> model, Patience patience)
      : model_(std::move(model)), patience_(patience) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType check) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override;

  /// The run, without the number of iterations and the end if the step limit was reached.
  const NewtonRun& history() const { return run_; }

 private:
  /// Of a step.
  struct Measured {
    double residual = 0;  ///< Evaluation::scaled
    double merit = 0;     ///< √(2Ψ) / Problem::stress
  };
  void record(const Evaluation& e, Measured measured);

  Teuchos::RCP<const ContactModel> model_;
  Patience patience_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  NewtonRun run_;
  bool isRounding(const ContactStates& set, double scaled) const;

  std::vector<ContactStates> sets_;
  ContactStates last_;                      ///< of the previous step
  std::map<ContactStates, Measured> seen_;  ///< the last step with this set
  double first_ = 0;
  double least_ = 0;          // merit
  double improved_ = 0;       // residual at the last progress: half of the one before
  std::size_t progress_ = 0;  // step of the last progress
  int settling_ = std::numeric_limits<int>::max();  // fewest changes of a step
};

}  // namespace epafi::contact
