#include "drivers/CommandLine.hpp"

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

/// An option of `epafi run`: with a value (an empty name of it: without one).
struct Option {
  const char* name;
  const char* value;
  void (*store)(RunOptions& options, const std::string& value);
};

constexpr Option options[] = {
    {"--output", "DIR",
     [](RunOptions& o, const std::string& value) {
       if (value.empty())
         throw bem::InputError("--output: the folder's name is empty");
       o.output = value;
     }},
    {"--set", "'A->B->Key=value'",
     [](RunOptions& o, const std::string& value) { o.overrides.push_back(value); }},
    {"--threads", "N",
     [](RunOptions& o, const std::string& value) {
       o.threads = positiveNumber("--threads", value);
     }},
    {"--force", "", [](RunOptions& o, const std::string&) { o.force = true; }},
    {"--quiet", "", [](RunOptions& o, const std::string&) { o.quiet = true; }},
};

const Option& optionNamed(const std::string& name) {
  std::vector<std::string> known;
  for (const Option& option : options) {
    if (name == option.name)
      return option;
    known.emplace_back(option.name);
  }
  throw bem::InputError(
      bem::message("run: unknown option '", name, "'", bem::suggestion(name, known)));
}

}  // namespace

RunOptions parseRunOptions(const std::vector<std::string>& arguments) {
  RunOptions result;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.empty() || argument[0] != '-') {
      if (!result.scene.empty())
        throw bem::InputError(bem::message("run: two scenes, '", result.scene, "' and '",
                                           argument, "'; one is allowed"));
      result.scene = argument;
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const Option& option = optionNamed(name);
    const bool takesValue = *option.value != '\0';
    std::string value;
    if (equals != std::string::npos && !takesValue)
      throw bem::InputError(bem::message("run: ", name, " takes no value"));
    if (equals != std::string::npos)
      value = argument.substr(equals + 1);
    else if (takesValue) {
      if (++i == arguments.size())
        throw bem::InputError(
            bem::message("run: ", name, " needs a value: ", name, " ", option.value));
      value = arguments[i];
    }
    option.store(result, value);
  }
  if (result.scene.empty())
    throw bem::InputError("run: no scene is given; usage: epafi run SCENE.xml [options]");
  return result;
}

std::string usage() {
  return R"(Epafi: frictional contact of linear elastic bodies in the plane

  epafi run SCENE.xml [options]     solve; a table row per level, files into a folder
      --output DIR                  default: ./<scene name>.out
      --set 'A->B->Key=value'       replace a value of the scene; repeatable
      --threads N                   OpenMP and BLAS together; default: all cores
      --force                       replace the files of an earlier run
      --quiet                       print nothing but errors
  epafi check SCENE.xml [--set 'A->B->Key=value']...
                                    read and validate only
  epafi parameters [--format text|xml|markdown]
                                    every parameter of a scene
  epafi plot DIR                    pictures of a finished run, .png and .svg
  epafi version                     what this program is made of
  epafi --help                      this page

Exit codes: 0 solved, 1 bad input or usage, 2 the arithmetic broke down, 3 not converged,
128 + signal when interrupted.
)";
}

void refuseCommand(const std::string& name) {
  throw bem::InputError(bem::message(
      "unknown command '", name, "'",
      bem::suggestion(name,
                      {"run", "check", "parameters", "plot", "version", "--help"})));
}

}  // namespace epafi::drivers
