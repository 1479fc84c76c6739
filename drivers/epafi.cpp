/// Frictional contact of linear elastic bodies in the plane.
///
///   epafi run SCENE.xml           solve: a table row per level, files into a folder
///   epafi check SCENE.xml         read and validate only
///   epafi parameters              every parameter of a scene
///   epafi version | --help
///
/// Sample run:  epafi run drivers/scenes/tresca.xml --set 'Adaptivity->Maximum Levels=3'

#include "bem/base/Error.hpp"
#include "drivers/BlasCore.hpp"
#include "drivers/CommandLine.hpp"
#include "drivers/Commands.hpp"
#include "drivers/Interrupt.hpp"
#include "drivers/RunCommand.hpp"

#include <iostream>

namespace {

namespace bem = epafi::bem;
namespace drivers = epafi::drivers;
using Arguments = std::vector<std::string>;

enum ExitCode { Solved = 0, BadInput = 1, Breakdown = 2 };

struct Command {
  const char* name;
  int (*run)(const Arguments& arguments, std::ostream& out);
};

int help(const Arguments&, std::ostream& out) {
  out << drivers::usage();
  return Solved;
}

constexpr Command commands[] = {
    {"run", drivers::runCommand},
    {"check", drivers::checkCommand},
    {"parameters", drivers::parametersCommand},
    {"version", drivers::versionCommand},
    {"--version", drivers::versionCommand},
    {"--help", help},
    {"-h", help},
    {"help", help},
};

int dispatch(const Arguments& arguments) {
  if (arguments.empty())
    throw bem::InputError("no command is given\n\n" + drivers::usage());
  for (const Command& command : commands)
    if (arguments.front() == command.name)
      return command.run({arguments.begin() + 1, arguments.end()}, std::cout);
  drivers::refuseCommand(arguments.front());
}

int fail(ExitCode code, const std::string& message) {
  std::cerr << "epafi: " << message << std::endl;
  return code;
}

}  // namespace

int main(int argc, char* argv[]) {
  drivers::restartWithFastBlas(argv);
  try {
    return dispatch({argv + 1, argv + argc});
  } catch (const bem::InputError& error) {
    return fail(BadInput, error.what());
  } catch (const drivers::Interrupted& interrupted) {
    return fail(static_cast<ExitCode>(128 + interrupted.signal),
                "interrupted; the levels that were solved are written");
  } catch (const std::bad_alloc&) {
    return fail(Breakdown, "the memory does not suffice for this level");
  } catch (const std::exception& error) {
    return fail(Breakdown, error.what());
  } catch (const char* error) {  // NOX throws these
    return fail(Breakdown, error);
  }
}
