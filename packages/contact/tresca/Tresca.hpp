#pragma once

#include "bem/base/SchemaRow.hpp"
#include "contact/solve/Course.hpp"
#include "contact/solve/NonlinearSolver.hpp"

#include <string>

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// What Newton's method does for problems with given slip bounds.
struct TrescaOptions {
  std::string complementarity = "Projection";  ///< a name of complementarities()
  double tolerance = 1e-12;                    ///< scaled residual, relative to the load
  int maximumIterations = 50;                  ///< steps of one run, see Course
};

/// The keys of a list of these, and what a list that they have completed says.
bem::SchemaRows trescaRows();
TrescaOptions parseTresca(const Teuchos::ParameterList& list);

/// Frictionless contact and Tresca's friction: slip bounds that do not depend on the
/// pressure.
///
/// Newton's steps, or chosen active sets; complementary pivoting.  Each only where the one before fails.
class Tresca final : public NonlinearSolver {
 public:
  /// `newton` must outlive this.
  explicit Tresca(const Newton& newton, const TrescaOptions& options = {})
      : NonlinearSolver(Course::runs * options.maximumIterations),
        newton_(newton),
        options_(options) {}

  const Newton& newton() const { return newton_; }
  const TrescaOptions& options() const { return options_; }

  /// Of a problem known to be sound.
  Solution solveSound(const Problem& problem, const State& start) const override;

 private:
  const Newton& newton_;
  TrescaOptions options_;
};

/// A course with Newton's method and the equations that it may solve.
class NewtonCourse : public Course {
 public:
  NewtonCourse(const Problem& problem, const State& start, const Tresca& tresca,
               Equation::Bound bound);

  const Tresca& tresca() const { return tresca_; }
  const Equation& equation() const { return equation_; }
  /// The same by the projection, which has active sets.
  const Equation& sharp() const { return sharp_; }

  const State& start() const { return start_; }
  /// Whether the start is a state, not zero; whether it says which sets are active, up to
  /// a few coefficients, and D's entries are there to pivot with.
  bool hasStart() const { return hasStart_; }
  bool knowsSets() const {
    return hasStart_ && equation_.hasActiveSets() && problem().flexibility.isFormed();
  }

  /// One run of Newton's, from where the course stands or from the best point.
  void steps(Stage stage, int most);
  void pivoting(Stage stage, const Equation& equation, const Vector& from);
  /// Complementary pivoting from no start, then Newton's last digits.  Where free motions
  /// are placed by springs, or a bound was a polygon's, a second path begins at the first
  /// one's end or from another direction.  The pivots count as the factorisations that take
  /// as many operations.
  void followOffset(Stage stage);

 private:
  const Tresca& tresca_;
  Equation equation_;
  Equation sharp_;
  State start_;
  bool hasStart_;
};

}  // namespace epafi::contact
