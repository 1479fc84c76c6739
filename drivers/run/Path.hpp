#pragma once

#include "contact/path/PathMemory.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/SolvedBodies.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// What friction's work counts as at least where an error is relative to it, as a part of the
/// work from outside: below it lie first touches of a mesh.
constexpr double leastFriction = 1e-4;

/// A contact in a row of steps.csv, in the user's units.
struct ContactRow {
  std::string name;
  contact::Summary summary;
  double dissipated = 0;  ///< friction's work so far
};

/// A row of steps.csv; energies so far, see contact::PathMemory, in the user's units.
struct StepRow {
  int level = 0;
  int step = 0;  ///< 1, 2, ...: the times that the scene asks for
  double t = 0;
  int newtonIterations = 0;  ///< of all parts of the step
  int parts = 1;  ///< in how many steps it was solved: more where one failed or erred
  bool converged = false;
  double energyStrain = 0;
  double energyDissipated = 0;
  double energyDissipatedError = 0;  ///< of it, in time; zero without History->Tolerance
  double energyTrapezoidal = 0;
  double energyOutside = 0;        ///< work of loads, clamps, obstacles, ends of springs
  double energyStabilisation = 0;  ///< what it stores
  double energyStored = 0;         ///< strain energy, stabilisation, surfaces, springs
  double energyInterface = 0;      ///< what the surfaces of contacts store
  double energySprings = 0;        ///< what springs of rigid bodies store
  double energyWorn = 0;           ///< work on what wears off
  double energyError = 0;          ///< outside - trapezoidal - worn - stored
  double cycles = 0;  ///< ∫ n dt, n how many times steps happen for what wears
  std::vector<ContactRow> contacts;
  std::vector<RigidRow> rigid;
  std::vector<contact::Summary> bodies;  ///< in scenes of several
};

/// A row without numbers: the names of contacts, with the body's in front where another one has
/// the same, and of bodies without elasticity, in their order.
StepRow emptyRow(const Scene& scene, const BodySpaces& spaces);

/// A solved step with all that its fields are made from.
struct PathStep {
  StepRow row;
  std::vector<contact::Conditions> conditions;
  std::unique_ptr<const contact::ContactSystem> system;
  std::unique_ptr<const SolvedBodies> solved;
  std::vector<bem::Vector> frictionWork;  ///< so far, one per body's tangential
                                          ///< coefficient, dimensionless
};

/// The steps of a path on one mesh.
struct Path {
  std::unique_ptr<const Placement> start;        ///< before the first: nothing has moved
  std::vector<std::unique_ptr<PathStep>> steps;  ///< those that were asked for
  std::vector<PathPoint> points;                 ///< every step that was solved
  contact::Report report;  ///< iterations of all; status of the last
  std::string reason;      ///< why the path ends early; else empty

  const PathStep& last() const { return *steps.back(); }
};

/// Follows the scene's path; operators, factors and D are those of `atZero` for all steps.
///
/// Each step starts where contact::Prediction says; one that fails is halved, down to
/// History->Minimum Step, and then the path ends there.  With History->Tolerance the steps
/// between two times asked for are halved until friction's work hardly changes, and the
/// last of these solutions is the path's.          [doc/theory/paths.md, Steps that fit]
/// `earlier` are points that an earlier run has solved: they are taken as they are.
/// `handOut` receives each step asked for as soon as it is solved, and the path so far.
/// Collective.
/// \throws bem::InputError, Interrupted.
Path followPath(const Ground& ground, const contact::ContactSystem& atZero,
                const std::vector<PathPoint>& earlier, PhaseTimer& timer,
                const std::function<void(const Path&)>& handOut);

}  // namespace epafi::drivers
