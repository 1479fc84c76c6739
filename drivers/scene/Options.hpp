#pragma once

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/Keys.hpp"
#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "contact/solve/CoulombIteration.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

class Ranks;

/// Options for solving linear systems.
struct LinearOptions {
  std::string method = "Automatic";  ///< a name in linearMethods()
  bem::BelosOptions belos;
  bem::Compression compression;

  void keys(bem::Keys& keys);
};

/// A method that solves systems with the boundary operators.
struct LinearMethod {
  /// Form of the operators: dense matrices, compressed operators, or the cheaper of both.
  enum class Operators { Dense, Compressed, Cheaper };

  const char* name = nullptr;
  const char* meaning = nullptr;
  /// A null pointer means Cholesky factorization.
  std::unique_ptr<const bem::SingleLayerSolver> (*solver)(
      const Ranks& ranks, const LinearOptions& options) = nullptr;
  Operators operators = Operators::Dense;
  bool factors = true;  ///< V, which may be nearly singular then, see Conditions::pins
};

/// All methods; a program may add others before it reads its first scene.
bem::Family<LinearMethod>& linearMethods();

/// The list Solver, see solve().
struct SolverOptions {
  contact::ContactSolverOptions contact;
  contact::CoulombOptions coulomb;
  /// Parameters for NOX in every run; null: the defaults of Epafi.
  std::shared_ptr<const Teuchos::ParameterList> nox;
  LinearOptions linear;

  void keys(bem::Keys& keys);  ///< without the lists NOX and Linear
};
/// Reads the validated list.
SolverOptions parseSolver(const Teuchos::ParameterList& list);

/// Limits that end a run.
struct RunLimits {
  int levels = 6;  ///< including the first
  /// Of a level, displacement and multiplier; empty: 4000, or twice the first mesh's.
  std::optional<double> degreesOfFreedom{};
  double estimate = 0;  ///< a smaller estimate ends the run
  /// A Level::relativeEstimate of at most this ends the run.
  std::optional<double> tolerance{};
  std::optional<double> memory;  ///< of a level, all processes [MiB]; empty: all free

  void keys(bem::Keys& keys) {
    keys.add(
        &tolerance, "Tolerance", "1", {0, 1, true, true},
        "a run ends at the first level whose estimated error is at most this part of "
        "the energy norm of the solution, on a path in every step; alone it means "
        "Strategy = Graded hp and Maximum Levels = 100");
    keys.add(&estimate, "Target Estimate",
             "as the estimate: root of stress length^2 under Weights Energy",
             bem::from(0), "a run ends at the first level with a smaller estimate");
    keys.add(&levels, "Maximum Levels", "1", bem::from(1),
             "levels computed, the first included");
    keys.add(
        &degreesOfFreedom, "Maximum Degrees of Freedom", "1", bem::from(1),
        "a level with more, displacement and contact stress together, is not computed; "
        "without it 4000, or twice the first mesh's if that is more");
    keys.add(&memory, "Maximum Memory", "MiB", bem::above(0),
             "a level that is predicted to need more, all processes together, is not "
             "computed; without it what the machine and its control groups have free");
  }
};

/// The list Adaptivity.
struct AdaptivityOptions {
  adaptivity::StrategyOptions strategy;
  adaptivity::EstimatorOptions estimator;
  RunLimits limits;

  void keys(bem::Keys& keys) {
    strategy.keys(keys);
    estimator.keys(keys);
    limits.keys(keys);
  }
};

/// The list Output: files of a level beside the tables.
struct OutputOptions {
  int contactSamples = 8;  ///< points per element
  std::vector<bem::Vec2> interiorPoints;
  bool fields = true;  ///< write boundary.csv and the files with fields

  void keys(bem::Keys& keys) {
    keys.add(
        &fields, "Fields", "", {},
        "write boundary.csv, the pictures' data, and solution.hdf, which restarts and "
        "epafi fields read");
    keys.add(&contactSamples, "Contact Samples per Element", "1", {1, 1000},
             "points in contact.csv");
    keys.add(&interiorPoints, "Interior Points", "length", {},
             "points inside the body for interior.csv");
  }
};

/// The path of the loads: it starts unloaded at t = 0 and is solved up to each of `times`
/// in this order.  One load is there at t = 1, from the beginning.
struct History {
  bool isPath = false;  ///< or one load
  std::vector<double> times{1};
  /// Shortest step; 0: 1/64 of a step, with a tolerance 1/1024.
  double minimumStep = 0;
  double tolerance = 0;  ///< relative time error of friction's work; 0: steps as given

  /// With a tolerance: smallest number of steps up to each time; fewer could miss loads
  /// that rise and fall in between.
  static constexpr int fewestSteps = 8;

  explicit operator bool() const { return isPath; }
  double start() const { return isPath ? 0 : 1; }
  double shortest(double step) const {
    return !isPath           ? step
           : minimumStep > 0 ? minimumStep
                             : step / (tolerance > 0 ? 1024 : 64);
  }
};

/// Schema rows of the list History.
bem::SchemaRows historyRows();
/// \throws bem::InputError if Times do not increase from 0, if the number of Steps is
///   neither 1 nor that of Times, if Minimum Step is too long for the Tolerance, or if
///   there are other keys without Times.
History parseHistory(const Teuchos::ParameterList& list);

}  // namespace epafi::drivers
