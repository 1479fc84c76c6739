#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/results/Summary.hpp"
#include "contact/solve/Report.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A solved step of a path, or a part of one.
struct PathPoint {
  double t = 0;
  contact::State state;
  int newtonIterations = 0;  ///< since the previous point, rejected steps included
  int coulombIterations = 0;
  /// Estimated time errors of friction's work and of the worn volume since the last point with
  /// some, dimensionless.
  double workError = 0;
  double volumeError = 0;
};

/// The solution at one time, dimensionless, by body: of a load, or of a step of a path (one of
/// History->Times and Steps).
struct StepFields {
  double t = 0;                       ///< 0 without a History
  std::vector<contact::State> own{};  ///< λ and rigid motions; a file has the last's
  std::vector<contact::ContactState> states{};  ///< of each coefficient of λ
  std::vector<bem::Vector> displacement{};      ///< all unknowns
  std::vector<bem::Vector> density{};           ///< traction on the whole boundary
  std::vector<contact::RigidMotion> rigid{};    ///< of rigid bodies
};

/// A level as numbers: the data for the next level, and of solution.hdf.  One that is to be
/// solved has its meshes, what it starts from as `steps` (empty: zero), and as `path` what an
/// earlier run has solved of it.
struct Level {
  int number = 0;
  contact::Status status = contact::Status::NotConverged;
  std::string reason{};                              ///< empty when converged
  std::vector<std::vector<bem::Piece>> meshes{};     ///< of each body, as in the scene
  std::vector<adaptivity::Indicators> indicators{};  ///< likewise
  std::vector<PathPoint> path{};                     ///< all solved steps, also parts
  /// The solution; at the end of a path in each step, before in the last one only, so that
  /// files written after steps do not grow.
  std::vector<StepFields> steps{};
  bool complete = true;  ///< has the path reached its end?  True without a History

  const StepFields& last() const { return steps.back(); }
  bool onPath() const { return last().t > 0; }
  /// The time of a step, `end` without a History; not behind the last that is solved.
  double timeOf(const StepFields& step, double end) const;

  /// Sums over all bodies.
  adaptivity::Contributions squares() const;
  double estimate() const;
  std::size_t elements() const;

  /// Estimated error over the energy norm of the solution, (2 energyStrain)^½.  On a path
  /// the largest of all steps, with norms of at least a tenth of the largest norm (steps
  /// without loads have norm zero).  Infinite if the norm is zero and the error is not;
  /// zero if both are the rounding of a motion without strain.
  double relativeEstimate = 0;
};

/// A contact or a rigid body in a row of a table, in the user's units; moments on a rigid body
/// are about its reference point.
struct PartRow {
  std::string name;
  contact::Summary summary{};
  double dissipated = 0;  ///< friction's work so far
};

/// A row of steps.csv, in the user's units; energies are sums over the path, see
/// contact::PathMemory.  Without a History the load's energies and rigid bodies.
struct StepRow {
  int level = 0;
  int step = 0;  ///< 1, 2, ... by History->Times and Steps
  double t = 0;
  int newtonIterations = 0;  ///< of all parts of the step
  int parts = 1;             ///< number of steps into which it was divided
  bool converged = false;
  double energyStrain = 0;
  double energyDissipated = 0;
  double energyDissipatedError = 0;  ///< its time error; zero without History->Tolerance
  double energyTrapezoidal = 0;
  double energyOutside = 0;        ///< work of loads, clamps, obstacles, ends of springs
  double energyStabilisation = 0;  ///< stored by the stabilisation
  double energyStored = 0;         ///< strain energy, stabilisation, surfaces, springs
  double energyInterface = 0;      ///< stored by contact surfaces
  double energySprings = 0;        ///< stored by springs of rigid bodies
  double energyWorn = 0;           ///< work of contact stresses on worn material
  double wornVolumeError = 0;      ///< time error of the worn volume, relative; likewise
  double energyError = 0;          ///< outside - trapezoidal - worn - stored
  double cycles = 0;  ///< ∫ n dt, n: how often steps are repeated, for wear
  std::vector<PartRow> contacts{};
  std::vector<PartRow> rigid{};
};

/// LevelRow::operators if compressed operators failed.
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
  double memoryForecast = 0;  ///< all processes [MiB]
  double memoryAllowed = 0;   ///< Maximum Memory, else what is free [MiB]
  /// Forecast for dense operators if they may replace compressed ones that fail: Method
  /// "Automatic", and they fit.
  std::optional<double> memoryOfDense{};
  contact::Summary summary{};  ///< over all bodies
  double energyFriction = 0;   ///< friction's work so far [stress length²]
  double energyInterface = 0;  ///< stored by contact surfaces [stress length²]
  contact::Report report{};
  std::string reason{};                 ///< empty when converged
  double gamma0 = 0;                    ///< zero without stabilisation
  double estimate = 0;                  ///< [(stress length²)^½] under Weights "Energy"
  double relativeEstimate = 0;          ///< see Level
  adaptivity::Contributions squares{};  ///< of the estimate, by source
  /// Step with the largest estimate, from 1; 0 without a History.
  int worstStep = 0;
  double worstEstimate = 0;                  ///< estimate of that step, else of the level
  std::array<double, phaseCount> seconds{};  ///< of this level, CPU, all threads
  double secondsTotal = 0;                   ///< CPU since the program's start
  double secondsWall = 0;                    ///< elapsed time since the timer's start
  double memory = 0;                         ///< peak so far [MiB]
  std::string operators = "dense";           ///< or "compressed", or denseInstead
  /// Advice on another Method or Form, or another remark on the operators; may be empty.
  std::string note{};

  bem::Index dof() const { return displacements + multipliers; }
  bool isCompressed() const { return operators == "compressed"; }
};

/// Results of the whole scene from those of the half (Geometry->Symmetry): twice the
/// components along the line, zero across it and for moments.  Without symmetry
/// unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half);

/// The same for one body, if the line cuts it; else unchanged.  \param pole  of the moments
contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn, bem::Vec2 pole = {});

}  // namespace epafi::drivers
