#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace epafi::drivers {

/// `epafi run SCENE.xml [options]`: solves a scene level by level and writes its files.
///
/// Returns 0, or 3 if a level is not converged.
/// \throws bem::InputError, bem::NumericalError, Interrupted: files of the levels before
/// are
///   written.
int runCommand(const std::vector<std::string>& arguments, std::ostream& out);

/// `epafi version`
int versionCommand(const std::vector<std::string>& arguments, std::ostream& out);

}  // namespace epafi::drivers
