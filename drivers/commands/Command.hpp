#pragma once

#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

class Ranks;
struct ExitMeaning;

/// The argument of a command that has no option name: a scene, a study, a folder.
struct Argument {
  std::string name;  ///< as in the usage: "SCENE.xml"; empty: no argument
  std::string what;  ///< "scene", for messages
  bool required = true;
};

/// "--output DIR".
struct Option {
  std::string name;  ///< with its two hyphens
  /// As in the usage, "DIR" or "FILE.png", by which completion knows what to offer; empty: a switch
  /// without a value.
  std::string value;
  std::string meaning;
  std::vector<std::string> words = {};  ///< allowed values; empty: any
  bool repeatable = false;
};

/// The arguments that the user gave to a command.
class Given {
 public:
  std::string argument;
  std::map<std::string, std::vector<std::string>> options;  ///< of a switch no values

  bool has(const std::string& option) const { return options.count(option) != 0; }
  /// The last value of an option; `otherwise` without it.
  std::string value(const std::string& option, const std::string& otherwise = "") const;
  std::vector<std::string> values(const std::string& option) const;
  /// All of it, for another program: "--key=value", the argument last.
  std::vector<std::string> words() const;
};

/// A command of the program, with all data for help, man page, completion and parser.
struct Command {
  std::string name;
  std::string purpose;  ///< one line
  Argument argument;
  std::vector<Option> options;
  /// Returns the exit code; exceptions become the exit codes 1 and 2.
  int (*run)(const Given& given, std::ostream& out, const Ranks& ranks);
};

/// All commands of the program, in the order of its help.  This table alone feeds the
/// parser, --help, the man page and the completion of the shell
/// (`description`).
const std::vector<Command>& commands();

inline const std::string programTitle =
    "frictional contact of linear elastic bodies in the plane";

/// "128 + signal"
std::string nameOf(const ExitMeaning& exit);

/// What an option does, and whether it may be given more than once.
std::string meaningOf(const Option& option);

/// "epafi run SCENE.xml [options]"
std::string usageLine(const Command& command);

/// What `epafi COMMAND --help` prints, and of all commands `epafi --help`.
std::string helpOf(const Command& command);
std::string helpOf(const std::vector<Command>& commands);

/// The commands with their purposes, a line each.
std::string listOf(const std::vector<Command>& commands);

/// The commands, the exit codes and all keys of scenes and studies in JSON, of which
/// python/epafi/describe.py makes the man page, the completion, the schemas and the tables.
std::string description(const std::vector<Command>& commands);

/// Runs the command that the arguments (without program name) give; returns its exit
/// code.
/// \throws bem::InputError for an unknown command, naming the nearest and all others, and
///   what the command throws.
int dispatch(const std::vector<std::string>& arguments, const Ranks& ranks);

/// Parses the arguments behind the name of a command: options before or behind the
/// argument, values as `--key value` or `--key=value`.  Every command has the option
/// `--help`.
/// \throws bem::InputError for an unknown option, naming the nearest, a missing or
///   superfluous value, a word that is not allowed, and anything but one argument where one
///   is wanted.
Given parseArguments(const Command& command, const std::vector<std::string>& arguments);

/// A whole number from 1 to `most`.
/// \throws bem::InputError naming the option.
int positiveNumber(const std::string& option, const std::string& text,
                   int most = std::numeric_limits<int>::max());

/// The value of --threads; 0 if it is not given.
int threadsOf(const Given& given);

}  // namespace epafi::drivers
