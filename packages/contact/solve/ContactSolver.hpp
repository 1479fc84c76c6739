#pragma once

#include "bem/base/Acceptor.hpp"
#include "contact/newton/Newton.hpp"
#include "contact/newton/OffsetPath.hpp"
#include "contact/solve/Report.hpp"

#include <utility>

namespace epafi::contact {

/// Solves condensed contact problems of one kind of friction.
class NonlinearSolver {
 public:
  virtual ~NonlinearSolver() = default;

  /// Slow convergence is reported, not thrown.
  /// \throws bem::NumericalError if the arithmetic breaks down (singular Jacobian, NaN);
  ///   NoBalance if nothing balances the load; and exceptions of Newton for its options
  Solution solve(const Problem& problem, const State& start) const;

 private:
  /// \pre the problem is sound
  virtual Solution solveSound(const Problem& problem, const State& start) const = 0;
};

/// Options of ContactSolver.
struct ContactSolverOptions {
  double tolerance = 1e-12;    ///< scaled residual, relative to the load
  int maximumIterations = 50;  ///< steps of one run
  double mostWork = 5e12;      ///< limit of operations of all pivots of a solve, see
                               ///< workOfPivot; about twenty minutes

  void keys(bem::Keys& keys);
};

/// Solver for frictionless contact and Tresca friction, whose slip bounds do not depend on the
/// pressure; its inStages() is also used by solvers for Coulomb friction.
class ContactSolver final : public NonlinearSolver,
                            public bem::Acceptor<ContactSolverOptions> {
 public:
  /// If D is not formed, the offset is followed for at most this many coefficients: more need a
  /// tableau of more than half a gigabyte and many minutes.
  static constexpr Index mostToPivot = 8000;

  /// Refers to `newton`.  \param watch receives the progress of a path of offsets
  explicit ContactSolver(const Newton& newton, ContactSolverOptions options = {},
                         OffsetWatch watch = {})
      : Acceptor(options), newton_(newton), watch_(std::move(watch)) {}

  const Newton& newton() const { return newton_; }
  const OffsetWatch& watch() const { return watch_; }

  /// inStages() with the derivative of the bound in the Jacobian.
  Solution solveSound(const Problem& problem, const State& start) const override;

  /// The stages of a solve, for any slip bound; the second runs if the first fails:
  ///
  ///   full steps      at most `steps` Newton steps; sweeps first if the start knows the active
  ///                   sets, see smoothed()
  ///   follow offset   complementary pivoting, independent of the start, at most `mostWork`
  ///                   operations; then Newton steps to full accuracy
  Solution inStages(const Problem& problem, const State& start, Equation::Bound bound,
                    int steps) const;

 private:
  const Newton& newton_;
  OffsetWatch watch_;
};

}  // namespace epafi::contact
