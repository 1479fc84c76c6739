#pragma once

#include "bem/base/SchemaRow.hpp"
#include "contact/newton/Newton.hpp"
#include "contact/newton/OffsetPath.hpp"
#include "contact/solve/NonlinearSolver.hpp"

#include <utility>

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// What Newton's method does for problems with given slip bounds.
struct ContactSolverOptions {
  double tolerance = 1e-12;    ///< scaled residual, relative to the load
  int maximumIterations = 50;  ///< steps of one run
  double mostWork = 5e12;      ///< operations of all pivots of a solve, see
                               ///< workOfPivot: some twenty minutes
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows contactSolverRows();
ContactSolverOptions parseContactSolver(const Teuchos::ParameterList& list);

/// What all solves are made of, see inStages; by itself it solves frictionless contact and
/// Tresca's friction, whose slip bounds do not depend on the pressure.
class ContactSolver final : public NonlinearSolver {
 public:
  /// Where D is not formed, the offset is followed up to as many coefficients: more make a
  /// table of more than half a gigabyte, and paths of many minutes.
  static constexpr Index mostToPivot = 8000;

  /// `newton` must outlive this.  `watch`: how far a path of offsets is.
  explicit ContactSolver(const Newton& newton, ContactSolverOptions options = {},
                         OffsetWatch watch = {})
      : newton_(newton), options_(options), watch_(std::move(watch)) {}

  const Newton& newton() const { return newton_; }
  const ContactSolverOptions& options() const { return options_; }
  const OffsetWatch& watch() const { return watch_; }

  /// In stages with the bound differentiated, of a problem known to be sound.
  Solution solveSound(const Problem& problem, const State& start) const override;

  /// The stages of every solve, whatever the bound follows:
  ///
  ///   full steps      Newton's, at most `steps`; a start that knows the active sets is
  ///                   swept before, see smoothed()
  ///   follow offset   complementary pivoting from no start, of at most `mostWork` operations,
  ///                   then Newton's last digits
  ///
  /// the second where the first fails.
  Solution inStages(const Problem& problem, const State& start, Equation::Bound bound,
                    int steps) const;

 private:
  const Newton& newton_;
  ContactSolverOptions options_;
  OffsetWatch watch_;
};

}  // namespace epafi::contact
