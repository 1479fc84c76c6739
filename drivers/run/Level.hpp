#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "contact/results/Summary.hpp"
#include "contact/solve/Report.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epafi::drivers {

/// The solution at one time, dimensionless: under the load, in a step of a path or in a part of
/// one.
struct SolvedState {
  double t = 0;              ///< 0 without a History
  contact::State state;      ///< of all bodies
  int newtonIterations = 0;  ///< since the previous point, rejected steps included
  int coulombIterations = 0;
  /// Estimated time errors of friction's work and of the worn volume, since the last point that
  /// has estimates.
  double workError = 0;
  double volumeError = 0;

  // of a load and of a step that the History defines
  contact::ContactStates states{};          ///< of each coefficient of λ
  std::vector<bem::Vector> displacement{};  ///< by body, all unknowns
  std::vector<bem::Vector> density{};       ///< likewise, traction on the whole boundary
  std::vector<contact::RigidMotion> rigid{};  ///< by rigid body
};

/// See contactEstimates.
struct ContactEstimate {
  std::string name;
  std::size_t carrier = 0;                   ///< the body that carries its stresses
  std::vector<int> closed{};                 ///< elements of that body
  std::vector<std::vector<int>> elements{};  ///< of each body, what its estimate is of
  double relative = 0;
  std::size_t body = 0;  ///< whose energy norm it is relative to
  double doubt = 0;      ///< see Level::doubts
};

/// The data of a level that the next level and solution.hdf need.  Before the solve it has its
/// meshes, in `steps` the start values (empty: zero), and in `path` the points that an earlier
/// run has solved.
struct Level {
  int number = 0;
  contact::Status status = contact::Status::NotConverged;
  std::string reason{};                              ///< empty when converged
  std::vector<std::vector<bem::Piece>> meshes{};     ///< of each body, as in the scene
  std::vector<adaptivity::Indicators> indicators{};  ///< likewise
  std::vector<SolvedState> path{};                   ///< all solved steps and parts
  /// The solution.  A finished path has all steps, an unfinished one only the last, so that
  /// files written after each step do not grow.
  std::vector<SolvedState> steps{};
  bool complete = true;  ///< has the path reached its end?  True without a History

  /// Converged, a path to its end?
  bool isSolved() const { return complete && status == contact::Status::Converged; }
  const SolvedState& last() const { return steps.back(); }
  bool onPath() const { return last().t > 0; }
  /// The time of a step, at most that of the last solved point; `end` without a History.
  double timeOf(const SolvedState& step, double end) const;

  /// Sums over all bodies.
  adaptivity::Contributions squares() const;
  double estimate() const;
  std::size_t elements() const;

  /// Estimated error over the energy norm of the solution, (2 energyStrain)^½.  On a path the
  /// maximum over all steps; each norm counts as at least a tenth of the largest one, since
  /// steps without loads have norm zero, and as at least a millionth of what strains as large as
  /// those of heat and weight would store.  Infinite if the norm is zero and the error is not;
  /// zero if both are rounding errors of what loads and motions could store.
  double relativeEstimate = 0;
  /// The largest strain energy of each body over the steps, of both halves of a symmetric scene, at
  /// least what rounding could store [stress length²].
  bem::Vector energies{};
  /// Of each contact, as in a StepRow, the error of the largest pressure over that, in the step in
  /// which it is largest; 0 where the pressure has no bound.
  bem::Vector doubts{};
  /// Of a solved level whose indicators are energies.
  std::vector<ContactEstimate> contacts{};
};

/// A row of steps.csv, in the user's units.  Works are sums over the path, see
/// contact::PathMemory.  A load without a History is one step, of number and time 0.
/// Contacts and rigid bodies stand under their names; moments on a rigid body are about its
/// reference point.
struct StepRow {
  int level = 0;
  int step = 0;  ///< 1, 2, ... by History->Times and Steps
  double t = 0;
  int newtonIterations = 0;  ///< over all parts of the step
  int parts = 1;             ///< number of parts into which it was divided
  bool converged = false;
  double energyStrain = 0;
  double energyDissipated = 0;
  double energyDissipatedError = 0;  ///< its time error; zero without History->Tolerance
  double energyTrapezoidal = 0;
  double energyOutside = 0;        ///< work of loads, clamps, obstacles, spring ends
  double energyStabilisation = 0;  ///< stored by the stabilisation
  double energyStored = 0;         ///< sum for strain, stabilisation, surfaces, springs
  double energyInterface = 0;      ///< stored by contact surfaces
  double energySprings = 0;        ///< stored by springs of rigid bodies
  double energyWorn = 0;           ///< work of contact stresses on worn material
  double wornVolumeError = 0;  ///< relative time error of the worn volume; zero as above
  double energyError = 0;      ///< residual: outside - trapezoidal - worn - stored
  double cycles = 0;           ///< ∫ n dt, n: the largest Cycle Jump of wear
  std::vector<std::pair<std::string, contact::Summary>> contacts{};
  std::vector<std::pair<std::string, contact::Summary>> rigid{};
};

/// LevelRow::operators if dense operators replace compressed ones that failed.
constexpr const char* denseInstead = "dense instead";

/// A row of history.csv, in the user's units.
struct LevelRow {
  int level = 0;
  int elements = 0;
  bem::Index displacements = 0;  ///< number of unknown displacements
  bem::Index multipliers = 0;
  bem::Index densities = 0;
  int degreeMin = 0;
  int degreeMax = 0;
  double sizeMin = 0;  ///< [length]
  double sizeMax = 0;
  double memoryForecast = 0;  ///< of all processes [MiB]
  double memoryAllowed = 0;   ///< Maximum Memory, else the free memory [MiB]
  /// Forecast for dense operators, if they may replace compressed ones that fail: under Method
  /// "Automatic", if they fit into memory.
  std::optional<double> memoryOfDense{};
  contact::Summary summary{};                                        ///< over all bodies
  std::vector<std::pair<std::string, contact::Summary>> contacts{};  ///< as in a StepRow
  double energyFriction = 0;   ///< friction's work so far [stress length²]
  double energyInterface = 0;  ///< stored by contact surfaces [stress length²]
  contact::Report report{};
  double gamma0 = 0;            ///< zero without stabilisation
  double estimate = 0;          ///< [(stress length²)^½] under Weights "Energy"
  double relativeEstimate = 0;  ///< see Level
  double contactEstimate = 0;   ///< the largest of a contact, see contactEstimates
  adaptivity::Contributions squares{};  ///< of the estimate, by source
  /// Step with the largest estimate, from 1; 0 without a History.
  int worstStep = 0;
  double worstEstimate = 0;                  ///< estimate of that step, else of the level
  std::array<double, phaseCount> seconds{};  ///< CPU of this level, all threads
  double secondsTotal = 0;                   ///< CPU since the program's start
  double secondsWall = 0;                    ///< elapsed since the start of the timer
  double memory = 0;                         ///< peak of the largest process so far [MiB]
  std::string operators = "dense";           ///< or "compressed", or denseInstead
  /// A remark on the operators, such as advice on another Method or Form; may be empty.
  std::string note{};

  bem::Index dof() const { return displacements + multipliers; }
  bool isCompressed() const { return operators == "compressed"; }
};

/// Results of the whole scene from those of the half (Geometry->Symmetry): energies, lengths and
/// force components along the line are doubled, components across it are zero, and moments are
/// those of a force on the line, about `pole`.  Without symmetry unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half,
                         bem::Vec2 pole = {});

/// The same for one body, if the line cuts it; else unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn, bem::Vec2 pole = {});

}  // namespace epafi::drivers
