#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// Runs a program with the standard streams of this one and waits for its end.
/// \return whether the program ended with exit code 0
/// \throws bem::InputError if it cannot be started: `what`, program, cause and `remedy`
bool runChild(const std::string& program, std::vector<std::string> arguments,
              const std::string& what, const std::string& remedy);

/// Runs a program of the Python package, "plot/__main__.py", in the same way; it starts this one
/// by the variable EPAFI.
/// \throws bem::InputError also if it is not there.
bool runPackage(const std::string& program, std::vector<std::string> arguments,
                const std::string& what);
/// Becomes a program of the Python package.
/// \throws bem::InputError likewise.
[[noreturn]] void becomePackage(const std::string& program,
                                std::vector<std::string> arguments,
                                const std::string& what);

/// Path of a file of the installation; `path` is relative to the parent of the folder of
/// this program.
std::string besideProgram(const std::string& path);

}  // namespace epafi::drivers
