#pragma once

#include <iosfwd>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

class Ranks;

/// What the shell offers where a value is wanted.
enum class Offer { Nothing, Scenes, Folders, Files, Words };

/// What stands behind a command without a name: a scene, a study, a folder.
struct Argument {
  std::string name;  ///< as in usages: "SCENE.xml"; empty: the command takes none
  std::string what;  ///< "scene", for messages
  Offer offer = Offer::Nothing;
  bool required = true;
};

/// "--output DIR".
struct Option {
  std::string name;   ///< with its two hyphens
  std::string value;  ///< as in usages; empty: a switch without a value
  std::string meaning;
  Offer offer = Offer::Nothing;
  std::vector<std::string> words = {};  ///< that are allowed; empty: any
  bool repeatable = false;
};

/// What the user wrote behind a command's name.
class Given {
 public:
  std::string argument;
  std::map<std::string, std::vector<std::string>> options;

  bool has(const std::string& option) const { return options.count(option) != 0; }
  /// The last value of an option; `otherwise` without it.
  std::string value(const std::string& option, const std::string& otherwise = "") const;
  std::vector<std::string> values(const std::string& option) const;
};

/// A command of the program: all that its help, the man page, the completion and the parser
/// say and know about it.
struct Command {
  std::string name;
  std::string purpose;  ///< one line
  Argument argument;
  std::vector<Option> options;
  /// Returns the exit code; throws what the codes 1 and 2 stand for.
  int (*run)(const Given& given, std::ostream& out, const Ranks& ranks);
};

/// All commands of the program, in the order of its help.  This table alone feeds the
/// parser, --help, the man page and the completion of the shell
/// (`description`).
const std::vector<Command>& commands();

/// Does what the arguments of main say, the program's name left out.  Returns the exit code.
/// \throws bem::InputError for an unknown command, naming the nearest and all others, and
///   what the command throws.
int dispatch(const std::vector<std::string>& arguments, const Ranks& ranks);

/// Of the arguments that follow the command's name, options before or behind the argument,
/// values as `--key value` or `--key=value`.  `--help` is an option of every command.
/// \throws bem::InputError for an unknown option, naming the nearest, a missing or
///   superfluous value, a word that is not allowed, and anything but one argument where one
///   is wanted.
Given parseArguments(const Command& command, const std::vector<std::string>& arguments);

/// A whole number from 1 to `most`.
/// \throws bem::InputError naming the option.
int positiveNumber(const std::string& option, const std::string& text,
                   int most = std::numeric_limits<int>::max());

/// --threads; 0: it is not given.
int threadsOf(const Given& given);

}  // namespace epafi::drivers
