#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/results/Summary.hpp"
#include "contact/solve/Report.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/scene/Scene.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A body on a solved level.
struct BodyLevel {
  std::vector<bem::Piece> pieces;  ///< the mesh
  contact::State state;            ///< its own λ and rigid motions
  contact::ContactState states;    ///< of each coefficient of λ
  bem::Vector displacement;        ///< all unknowns, dimensionless
  bem::Vector density;             ///< traction on the whole boundary, dimensionless
  adaptivity::Indicators indicators{};
};

/// A solved step of a path.
struct PathPoint {
  double t = 0;
  contact::State state;
  int newtonIterations = 0;  ///< since the previous point, rejected steps included
  int coulombIterations = 0;
  /// Estimated time error of friction's work since the last point with one, dimensionless.
  double workError = 0;
};

/// Fields at a step of a path (one of History->Times and Steps), by body.
struct StepFields {
  double t = 0;
  std::vector<bem::Vector> displacement;
  std::vector<bem::Vector> density;
  std::vector<contact::ContactState> states{};
  std::vector<contact::RigidMotion> rigid{};  ///< of rigid bodies
};

/// A solved level as numbers: the data for the next level, and of solution.hdf.
struct Level {
  int number = 0;
  contact::Status status = contact::Status::NotConverged;
  std::string reason;                         ///< empty when converged
  std::vector<BodyLevel> bodies;              ///< in the order of the scene
  std::vector<contact::RigidMotion> rigid{};  ///< likewise, dimensionless

  /// Sums over all bodies.
  adaptivity::Contributions squares() const;
  double estimate() const;
  std::size_t elements() const;

  /// Estimated error over the energy norm of the solution, (2 energyStrain)^½.  On a path
  /// the largest of all steps, with norms of at least a tenth of the largest norm (steps
  /// without loads have norm zero).  Infinite if the norm is zero and the error is not;
  /// zero if both are the rounding of a motion without strain.
  double relativeEstimate = 0;

  /// All solved steps, at the end of a path; before, see SolvedLevel::path.
  std::vector<PathPoint> path{};
  /// Fields of each step, at the end of a path only, so that files written after steps
  /// before do not grow.
  std::vector<StepFields> steps{};
  /// t of the last state; `end`: the value without a History.
  double time(double end) const { return path.empty() ? end : path.back().t; }
  /// The steps; without a History one with t = 0.
  std::vector<StepFields> solved() const;
  /// Has the path reached its end?  True without a History.
  bool complete = true;
};

/// Size of a mesh and of the spaces on it.
struct Size {
  int elements = 0;
  bem::Index displacements = 0;  ///< number of unknown displacements
  bem::Index multipliers = 0;
  bem::Index densities = 0;
  int degreeMin = 0;
  int degreeMax = 0;
  double sizeMin = 0;  ///< [length]
  double sizeMax = 0;
  double memory = 0;  ///< forecast, all processes [MiB]

  bem::Index dof() const { return displacements + multipliers; }
  Size& operator+=(const Size& other);
};

Size sizeOf(const bem::Space& space, const contact::MultiplierSpace& multiplier,
            const contact::Conditions& conditions);

/// A rigid body: its motion [length, radian], and forces on it with their moments about the
/// reference point.
struct RigidRow {
  std::string name;
  bem::Vec2 pole;
  contact::RigidMotion motion;
  contact::Resultant load;      ///< given with the scene
  contact::Resultant reaction;  ///< of prescribed motions and springs
  contact::Resultant contact;   ///< of all contacts
  contact::Resultant inside;    ///< of body loads; the sum of all four is zero
};

/// Results of the whole scene from those of the half (Geometry->Symmetry): twice the
/// components along the line, zero across it and for moments.  Without symmetry
/// unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half);

/// The same for one body, if the line cuts it; else unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn);
std::vector<contact::Summary> wholeBodies(const Scene& scene,
                                          std::vector<contact::Summary> drawn);
RigidRow wholeOf(const Symmetry& symmetry, const bem::Outline& outline, RigidRow drawn);

/// LevelRow::operators if compressed operators failed.
constexpr const char* denseInstead = "dense instead";

/// A row of history.csv.
struct LevelRow {
  int level = 0;
  Size size;
  contact::Summary summary;    ///< over all bodies
  double energyFriction = 0;   ///< friction's work so far [stress length²]
  double energyInterface = 0;  ///< stored by contact surfaces [stress length²]
  std::vector<contact::Summary> bodies{};  ///< of each
  std::vector<RigidRow> rigid{};
  contact::Report report;
  std::string reason;                   ///< empty when converged
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
  std::string note{};                        ///< remark on the operators; may be empty
  double defect = 0;                         ///< see contact::Configuration
};

struct Path;

/// A level, or a step of its path, passed to a callback; valid during the call only.
struct SolvedLevel {
  const std::vector<contact::Solved>& bodies;
  const Level& level;
  LevelRow row;
  const Path* path = nullptr;  ///< its steps so far; null without a History
};

}  // namespace epafi::drivers
