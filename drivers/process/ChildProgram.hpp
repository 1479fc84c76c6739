#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// Runs a program with arguments, its words where this program's go, and waits for its end.
/// \return whether it ended with code 0
/// \throws bem::InputError if it cannot be started: `what`, the program, the cause and `remedy`
bool runChild(const std::string& program, std::vector<std::string> arguments,
              const std::string& what, const std::string& remedy);

/// Where a file of the installation lies, `path` relative to the folder above that of this
/// program.
std::string besideProgram(const std::string& path);

}  // namespace epafi::drivers
