#pragma once

#include "drivers/run/SolvedStep.hpp"

#include <functional>

namespace epafi::drivers {

/// Smallest reference value of relative errors of friction's work, over the external
/// work: less comes from first contacts on a mesh.
constexpr double leastFriction = 1e-4;

/// The problem at History::start().
struct PathStart {
  std::shared_ptr<const SolvedStep::Conditions> conditions;
  std::shared_ptr<contact::ContactSystem> system;
};

/// Solves the path of the scene into `path`: its steps, the points and the reason of its level,
/// the report of its row.  All steps use operators, factors and D of `start`.
///
/// One load is a path of one step, which is the problem that it starts with; it is not halved, and
/// keeps no points.
///
/// A step starts from contact::Prediction, the first one from `from`.  If it fails it is
/// halved, down to History->Minimum Step; there the path ends.  With History->Tolerance
/// steps are halved until the time error of friction's work is small enough.
///                                            [doc/theory/paths.md, Choice of the steps]
/// Collective.
/// \param from its points were solved by an earlier run, and are not solved again; its state
///   is a start at the first of History->Times
/// \param handOut called after each step of History
/// \throws bem::InputError, Interrupted.
void followPath(const BodySpaces& spaces, const PathStart& start, const Level& from,
                const Run& run, const std::function<void()>& handOut, SolvedLevel& path);

}  // namespace epafi::drivers
