#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "drivers/run/LevelPlan.hpp"
#include "drivers/run/NextLevel.hpp"

#include <functional>
#include <string>
#include <variant>

namespace epafi::drivers {

/// A level that is about to be solved.
struct NewLevel {
  const Plan& plan;
  PhaseTimer& timer;
  const std::function<void(const SolvedLevel&)>& handOut;      ///< see solveLevels
  const std::function<void(const SolvedLevel&)>& handOutStep;  ///< likewise; may be empty
};

/// A level that was handed out, or the reason why dense operators have to solve it instead.
using Attempt = std::variant<Level, std::string>;

/// Forms and factors the operators of all bodies, makes the contact system, solves it for the
/// load or for all steps of the path, estimates the error and hands out the level.  Collective.
/// \param krylov solves with V; null: its factor does
/// \throws bem::InputError if nothing holds a body; bem::NumericalError, Interrupted
Attempt solveLevel(const Scene& scene, const BodySpaces& spaces,
                   const bem::Processes& processes, const bem::SingleLayerSolver* krylov,
                   const LevelStart& from, const NewLevel& begun);

}  // namespace epafi::drivers
