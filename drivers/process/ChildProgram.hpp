#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// Runs a program with the standard streams of this one and waits for its end.
/// \return whether the program ended with exit code 0
/// \throws bem::InputError if it cannot be started: `what`, program, cause and `remedy`
bool runChild(const std::string& program, std::vector<std::string> arguments,
              const std::string& what, const std::string& remedy);

/// Path of a file of the installation; `path` is relative to the parent of the folder of
/// this program.
std::string besideProgram(const std::string& path);

}  // namespace epafi::drivers
