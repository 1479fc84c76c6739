#pragma once

#include "drivers/commands/Command.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// "epafi run SCENE.xml [options]"
std::string usageLine(const Command& command);

/// What `epafi COMMAND --help` prints.
std::string helpOf(const Command& command);

/// What `epafi --help` prints: every command with its options.
std::string helpOf(const std::vector<Command>& commands);

/// The commands with their purposes, a line each.
std::string listOf(const std::vector<Command>& commands);

/// The same as a page for man(1).
std::string manPage(const std::vector<Command>& commands);

/// The commands as a completion for bash.
std::string bashCompletion(const std::vector<Command>& commands);

}  // namespace epafi::drivers
