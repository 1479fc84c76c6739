#pragma once

#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

class Ranks;

/// What the completion of the shell offers for a value.
enum class Offer { Nothing, Scenes, Folders, Files, Words };

/// The argument of a command that has no option name: a scene, a study, a folder.
struct Argument {
  std::string name;  ///< as in the usage: "SCENE.xml"; empty: no argument
  std::string what;  ///< "scene", for messages
  Offer offer = Offer::Nothing;
  bool required = true;
};

/// "--output DIR".
struct Option {
  std::string name;   ///< with its two hyphens
  std::string value;  ///< as in the usage; empty: a switch without a value
  std::string meaning;
  Offer offer = Offer::Nothing;
  std::vector<std::string> words = {};  ///< allowed values; empty: any
  bool repeatable = false;
};

/// The arguments that the user gave to a command.
class Given {
 public:
  std::string argument;
  std::map<std::string, std::vector<std::string>> options;

  bool has(const std::string& option) const { return options.count(option) != 0; }
  /// The last value of an option; `otherwise` without it.
  std::string value(const std::string& option, const std::string& otherwise = "") const;
  std::vector<std::string> values(const std::string& option) const;
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
