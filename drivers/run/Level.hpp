#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/results/Summary.hpp"
#include "contact/solve/Report.hpp"
#include "drivers/process/PhaseTimer.hpp"

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
  int newtonIterations = 0;  ///< since the point before, of steps that were left, too
  int coulombIterations = 0;
  /// Of friction's work since the last point that tells one, in time, dimensionless.
  double workError = 0;
};

/// What is inside the bodies at a step of a path that was asked for, of each body.
struct StepFields {
  double t = 0;
  std::vector<bem::Vector> displacement;
  std::vector<bem::Vector> density;
  std::vector<contact::ContactState> states{};
  std::vector<contact::RigidMotion> rigid{};  ///< of bodies without elasticity
};

/// A solved level as numbers: all that the next one is made from, and what a file keeps.
struct Level {
  int number = 0;
  contact::Status status = contact::Status::NotConverged;
  std::string reason;                         ///< empty when converged
  std::vector<BodyLevel> bodies;              ///< as the scene has them
  std::vector<contact::RigidMotion> rigid{};  ///< likewise, dimensionless

  /// Over all bodies.
  adaptivity::Contributions squares() const;
  double estimate() const;
  std::size_t elements() const;

  /// The estimated error over the energy norm of the solution, (2 energyStrain)^½; on a path the
  /// largest of any step, whose norm counts as at least a tenth of the largest one: a step
  /// without a load has none.  Infinite where only the error is not zero.
  double relativeEstimate = 0;

  /// All steps that led to a state at the end of a path; on the way SolvedLevel's Path has them.
  std::vector<PathPoint> path{};
  /// Of each step that was asked for, at the end of a path only: a file on the way would grow
  /// with every step that it is written after.
  std::vector<StepFields> steps{};
  /// Of its last state; `end`: of scenes without a History.
  double time(double end) const { return path.empty() ? end : path.back().t; }
  /// The steps, or the one state that there is without a History, whose t is 0.
  std::vector<StepFields> solved() const;
  /// Did the path get to its end, or is this a step on the way?  True without a History.
  bool complete = true;
};

/// What a mesh and the spaces on it are.
struct Size {
  int elements = 0;
  bem::Index displacements = 0;  ///< unknown ones: without the prescribed
  bem::Index multipliers = 0;
  bem::Index densities = 0;
  int degreeMin = 0;
  int degreeMax = 0;
  double sizeMin = 0;  ///< [length]
  double sizeMax = 0;
  double memory = 0;  ///< foretold, all processes [MiB]

  bem::Index dof() const { return displacements + multipliers; }
  Size& operator+=(const Size& other);
};

Size sizeOf(const bem::Space& space, const contact::MultiplierSpace& multiplier,
            const contact::Conditions& conditions);

/// A body without elasticity: its motion [length, radian], and forces on it with their
/// moments about the reference point.
struct RigidRow {
  std::string name;
  bem::Vec2 pole;
  contact::RigidMotion motion;
  contact::Resultant load;      ///< given with the scene
  contact::Resultant reaction;  ///< of what gives it its motion
  contact::Resultant contact;   ///< of all contacts
  contact::Resultant inside;    ///< of what acts inside; all four add up to nothing
};

/// Says of a level that compressed operators failed on it.
constexpr const char* denseInstead = "dense instead";

/// A row of history.csv.
struct LevelRow {
  int level = 0;
  Size size;
  contact::Summary summary;                ///< over all bodies
  double energyFriction = 0;               ///< friction's work so far [stress length²]
  double energyInterface = 0;              ///< what the surfaces of contacts store
  std::vector<contact::Summary> bodies{};  ///< of each
  std::vector<RigidRow> rigid{};
  contact::Report report;
  std::string reason;                   ///< empty when converged
  double gamma0 = 0;                    ///< zero without stabilisation
  double estimate = 0;                  ///< [(stress length²)^½] under Weights "Energy"
  double relativeEstimate = 0;          ///< see Level
  adaptivity::Contributions squares{};  ///< of which it is made
  /// With a History the step whose estimate is the largest, from 1; else 0.
  int worstStep = 0;
  double worstEstimate = 0;                  ///< that step's own, else that of the level
  std::array<double, phaseCount> seconds{};  ///< of this level, CPU, all threads
  double secondsTotal = 0;                   ///< CPU since the program's start
  double secondsWall = 0;           ///< by the clock on the wall since the timer's
  double memory = 0;                ///< peak so far [MiB]
  std::string operators = "dense";  ///< or "compressed", or denseInstead
  std::string note{};               ///< what to tell about them; mostly empty
  double defect = 0;                ///< see contact::Configuration
};

struct Path;

/// A level, or a step on the way to one, as it is handed out: valid during the call only.
struct SolvedLevel {
  const std::vector<contact::Solved>& bodies;
  const Level& level;
  LevelRow row;
  const Path* path = nullptr;  ///< its steps so far, where the scene has a History
};

}  // namespace epafi::drivers
