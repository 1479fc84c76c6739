#pragma once

#include "drivers/commands/Command.hpp"
#include "drivers/process/ExitCode.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

inline const std::string title =
    "frictional contact of linear elastic bodies in the plane";

/// "128 + signal"
std::string nameOf(const ExitMeaning& exit);

/// What an option does, and whether it may be given more than once.
std::string meaningOf(const Option& option);

/// "epafi run SCENE.xml [options]"
std::string usageLine(const Command& command);

/// What `epafi COMMAND --help` prints.
std::string helpOf(const Command& command);

/// What `epafi --help` prints: every command with its options.
std::string helpOf(const std::vector<Command>& commands);

/// The commands with their purposes, a line each.
std::string listOf(const std::vector<Command>& commands);

/// The commands, the exit codes and all keys of scenes and studies in JSON, of which
/// python/epafi/describe.py makes the man page, the completion, the schemas and the tables.
std::string description(const std::vector<Command>& commands);

}  // namespace epafi::drivers
