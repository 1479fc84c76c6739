#include "drivers/Program.hpp"

#include "bem/base/Error.hpp"
#include "drivers/commands/CommandLine.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/commands/PlotCommand.hpp"
#include "drivers/commands/RunCommand.hpp"
#include "drivers/commands/StudyCommand.hpp"
#include "drivers/process/BlasCore.hpp"
#include "drivers/process/Ranks.hpp"

#include <iostream>

namespace epafi {

namespace {

using Arguments = std::vector<std::string>;
using drivers::Ranks;

/// Returns the exit code; throws what the code 1 and 2 stand for.
struct Command {
  const char* name;
  int (*run)(const Arguments& arguments, std::ostream& out, const Ranks& ranks);
};

/// A command that needs one process only: each has it, the first one is heard.
template <int (*Run)(const Arguments&, std::ostream&)>
int alone(const Arguments& arguments, std::ostream& out, const Ranks&) {
  return Run(arguments, out);
}

int help(const Arguments&, std::ostream& out) {
  out << drivers::usage();
  return 0;
}

constexpr Command commands[] = {
    {"run", drivers::runCommand},
    {"study", drivers::studyCommand},
    {"check", alone<drivers::checkCommand>},
    {"parameters", alone<drivers::parametersCommand>},
    {"plot", drivers::plotCommand},
    {"version", alone<drivers::versionCommand>},
    {"--version", alone<drivers::versionCommand>},
    {"--help", alone<help>},
    {"-h", alone<help>},
    {"help", alone<help>},
};

int dispatch(const Arguments& arguments, const Ranks& ranks) {
  if (arguments.empty())
    throw bem::InputError("no command is given\n\n" + drivers::usage());
  std::ostream silence(nullptr);
  for (const Command& command : commands)
    if (arguments.front() == command.name)
      return command.run({arguments.begin() + 1, arguments.end()},
                         ranks.isFirst() ? std::cout : silence, ranks);
  drivers::refuseCommand(arguments.front());
}

}  // namespace

int program(int argc, char* argv[]) {
  drivers::restartWithFastBlas(argv);
  const Ranks ranks;
  int code = 0;
  const auto failure = ranks.attempt([&] {
    code = dispatch({argv + 1, argv + argc}, ranks);
  });
  if (!failure)
    return code;
  if (ranks.isFirst())
    drivers::tell(*failure);
  return failure->code;
}

}  // namespace epafi
