#pragma once

#include "drivers/commands/Command.hpp"

namespace epafi::drivers {

/// All commands of the program, in the order of its help.  This table alone feeds the
/// parser, --help, the man page and the completion of the shell
/// (`description`).
const std::vector<Command>& commands();

/// Does what the arguments of main say, the program's name left out.  Returns the exit code.
/// \throws bem::InputError for an unknown command, naming the nearest and all others, and
///   what the command throws.
int dispatch(const std::vector<std::string>& arguments, const Ranks& ranks);

}  // namespace epafi::drivers
