#pragma once

#include "drivers/run/SolvedBodies.hpp"

namespace epafi::drivers {

/// The row of history.csv of a solved level, without what its caller knows: size, operators,
/// note, report, friction's work and the worst step.  Collective.
LevelRow makeRow(const Ground& ground, const Level& level,
                 const contact::ContactSystem& system, const SolvedBodies& solved);

/// CPU seconds of the level's phases, elapsed seconds and memory until now, the largest of
/// all processes.  Collective.
void addTimes(const bem::Processes& processes, const PhaseTimer& timer, LevelRow& row);

}  // namespace epafi::drivers
