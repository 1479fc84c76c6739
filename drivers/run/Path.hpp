#pragma once

#include "contact/path/PathMemory.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/SolvedBodies.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Smallest reference value of relative errors of friction's work, over the external
/// work: less comes from first contacts on a mesh.
constexpr double leastFriction = 1e-4;

/// A contact in a row of steps.csv, in the user's units.
struct ContactRow {
  std::string name;
  contact::Summary summary;
  double dissipated = 0;  ///< friction's work so far
};

/// A row of steps.csv, in the user's units; energies are sums over the path, see
/// contact::PathMemory.
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
  double energyError = 0;          ///< outside - trapezoidal - worn - stored
  double cycles = 0;  ///< ∫ n dt, n: how often steps are repeated, for wear
  std::vector<ContactRow> contacts;
  std::vector<RigidRow> rigid;
  std::vector<contact::Summary> bodies;  ///< empty with one body
};

/// A row with names only: of contacts, preceded by that of the body if not unique, and of
/// rigid bodies, in the order of the scene.
StepRow emptyRow(const Scene& scene, const BodySpaces& spaces);

/// A solved step with the data of its fields.
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
  std::unique_ptr<const Placement> start;        ///< before the first step: zero
  std::vector<std::unique_ptr<PathStep>> steps;  ///< by History->Times and Steps
  std::vector<PathPoint> points;                 ///< all solved steps, also parts
  contact::Report report;  ///< iterations of all; status of the last
  std::string reason;      ///< why the path ends early; else empty

  const PathStep& last() const { return *steps.back(); }
};

/// Solves the path of the scene; all steps use operators, factors and D of `atZero`.
///
/// A step starts from contact::Prediction, the first one from `first`.  If it fails it is
/// halved, down to History->Minimum Step; there the path ends.  With History->Tolerance
/// steps are halved until the time error of friction's work is small enough.
///                                                  [doc/theory/paths.md, Steps that fit]
/// Collective.
/// \param first  start at the first of History->Times; empty vectors: zero
/// \param earlier points solved by an earlier run, which are not solved again
/// \param handOut called with the path so far after each step of History
/// \throws bem::InputError, Interrupted.
Path followPath(const Ground& ground, const contact::ContactSystem& atZero,
                const contact::State& first, const std::vector<PathPoint>& earlier,
                PhaseTimer& timer, const std::function<void(const Path&)>& handOut);

}  // namespace epafi::drivers
