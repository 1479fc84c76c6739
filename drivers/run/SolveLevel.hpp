#pragma once

#include "drivers/run/SolvedStep.hpp"

#include <string>
#include <variant>

namespace epafi::drivers {

/// A level that was handed out, or the reason why dense operators have to solve it instead.
using Attempt = std::variant<Level, std::string>;

/// Forms and factors the operators of all bodies, makes the contact system, solves it for the
/// load or for all steps of the path, estimates the error and hands out the level.  Collective.
/// \param planned see planOf
/// \throws bem::InputError if nothing holds a body; bem::NumericalError, Interrupted
Attempt solveLevel(const BodySpaces& spaces, const Level& from, const LevelRow& planned,
                   const Run& run);

}  // namespace epafi::drivers
