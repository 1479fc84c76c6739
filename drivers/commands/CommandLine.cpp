#include "drivers/commands/CommandLine.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"

#include <charconv>

namespace epafi::drivers {

namespace {

int positiveNumber(const std::string& option, const std::string& text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < 1)
    throw bem::InputError(
        bem::message(option, ": '", text, "' is not a whole number >= 1"));
  return value;
}

/// Which commands know an option.
enum class For { Run, RunAndStudy };

/// An option: with a value (an empty name of it: without one).
struct Option {
  const char* name;
  const char* value;
  For commands;
  void (*store)(RunOptions& options, const std::string& value);
};

constexpr Option options[] = {
    {"--output", "DIR", For::RunAndStudy,
     [](RunOptions& o, const std::string& value) {
       if (value.empty())
         throw bem::InputError("--output: the folder's name is empty");
       o.output = value;
     }},
    {"--set", "'A->B->Key=value'", For::Run,
     [](RunOptions& o, const std::string& value) { o.overrides.push_back(value); }},
    {"--threads", "N", For::RunAndStudy,
     [](RunOptions& o, const std::string& value) {
       o.threads = positiveNumber("--threads", value);
     }},
    {"--restart", "DIR", For::Run,
     [](RunOptions& o, const std::string& value) {
       if (value.empty())
         throw bem::InputError("--restart: the folder's name is empty");
       o.restart = value;
     }},
    {"--force", "", For::RunAndStudy,
     [](RunOptions& o, const std::string&) { o.force = true; }},
    {"--quiet", "", For::RunAndStudy,
     [](RunOptions& o, const std::string&) { o.quiet = true; }},
};

const Option& optionNamed(const std::string& name, const std::string& command) {
  std::vector<std::string> known;
  for (const Option& option : options) {
    if (command != "run" && option.commands == For::Run)
      continue;
    if (name == option.name)
      return option;
    known.emplace_back(option.name);
  }
  throw bem::InputError(bem::message(command, ": unknown option '", name, "'",
                                     bem::suggestion(name, known)));
}

/// `file`: what the command wants, "scene" or "study".
RunOptions parse(const std::string& command, const std::string& file,
                 const std::vector<std::string>& arguments) {
  RunOptions result;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.empty() || argument[0] != '-') {
      if (!result.scene.empty())
        throw bem::InputError(bem::message(command, ": two files, '", result.scene,
                                           "' and '", argument, "'; one ", file,
                                           " is allowed"));
      result.scene = argument;
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const Option& option = optionNamed(name, command);
    const bool takesValue = *option.value != '\0';
    std::string value;
    if (equals != std::string::npos && !takesValue)
      throw bem::InputError(bem::message(command, ": ", name, " takes no value"));
    if (equals != std::string::npos)
      value = argument.substr(equals + 1);
    else if (takesValue) {
      if (++i == arguments.size())
        throw bem::InputError(bem::message(command, ": ", name, " needs a value: ", name,
                                           " ", option.value));
      value = arguments[i];
    }
    option.store(result, value);
  }
  if (result.scene.empty())
    throw bem::InputError(bem::message(command, ": no ", file, " is given; usage: epafi ",
                                       command, " FILE.xml [options]"));
  return result;
}

}  // namespace

RunOptions parseRunOptions(const std::vector<std::string>& arguments) {
  return parse("run", "scene", arguments);
}

RunOptions parseStudyOptions(const std::vector<std::string>& arguments) {
  return parse("study", "study", arguments);
}

std::string usage() {
  return R"(Epafi: frictional contact of linear elastic bodies in the plane

  epafi run SCENE.xml [options]     solve; a table row per level, files into a folder
      --output DIR                  default: ./<scene name>.out
      --set 'A->B->Key=value'       replace a value of the scene; repeatable
      --threads N                   OpenMP and BLAS together; default: all cores
      --restart DIR                 go on from the last level in DIR, in DIR itself or
                                    in --output; what the scene may change: caps,
                                    strategy, solver, output
      --force                       replace the files of an earlier run
      --quiet                       print nothing but errors
  epafi study STUDY.xml [options]   run variants of scenes; error against dof and time
      --output, --threads, --force, --quiet as above; references are kept
  epafi check SCENE.xml [--set 'A->B->Key=value']...
                                    read and validate only
  epafi parameters [--format text|xml|markdown]
                                    every parameter of a scene
  epafi plot DIR                    pictures of a finished run or study
  epafi version                     what this program is made of
  epafi --help                      this page

Exit codes: 0 solved, 1 bad input or usage, 2 the arithmetic broke down, 3 not converged,
128 + signal when interrupted.
)";
}

void refuseCommand(const std::string& name) {
  throw bem::InputError(bem::message(
      "unknown command '", name, "'",
      bem::suggestion(
          name, {"run", "study", "check", "parameters", "plot", "version", "--help"})));
}

}  // namespace epafi::drivers
