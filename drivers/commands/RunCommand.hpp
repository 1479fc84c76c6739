#pragma once

#include "drivers/commands/Command.hpp"

namespace epafi::drivers {

/// `epafi run SCENE.xml [options]`: solves a scene level by level and writes its files.
///
/// Returns 0, or 3 if a level is not converged.
/// \throws bem::InputError, bem::NumericalError, Interrupted: files of the levels before
///   are written.
/// Collective; `out` and the files belong to the first rank.
int runCommand(const Given& given, std::ostream& out, const Ranks& ranks);

/// `epafi version`
int versionCommand(const Given& given, std::ostream& out);

}  // namespace epafi::drivers
