#include "drivers/commands/Command.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/scene/Text.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <sstream>

namespace epafi::drivers {

namespace {

using bem::InputError;

/// What no option and no argument takes.
[[noreturn]] void refuse(const Command& command, const std::string& text,
                         const std::string& argument) {
  if (text.size() > 1 && text[0] == '-') {
    std::vector<std::string> known{"--help"};
    for (const Option& option : command.options)
      known.push_back(option.name);
    const std::string name = text.substr(0, text.find('='));
    throw InputError(command.name, ": unknown option '", name, "'",
                     bem::suggestion(name, known));
  }
  if (command.argument.name.empty())
    throw InputError(command.name, ": argument '", text,
                     "' is not understood; usage: ", usageLine(command));
  throw InputError(command.name, ": two arguments, '", argument, "' and '", text,
                   "'; one ", command.argument.what, " is allowed");
}

/// Reports errors that CLI11 would report in other words.
void checkForm(const Command& command, const std::vector<std::string>& arguments) {
  for (const Option& option : command.options) {
    const bool wanted = !option.value.empty();
    if (wanted && !arguments.empty() &&
        (arguments.back() == option.name || arguments.back() == option.name + "="))
      throw InputError(command.name, ": ", option.name, " needs a value: ", option.name,
                       " ", option.value);
    for (const std::string& argument : arguments)
      if (!wanted && argument.rfind(option.name + "=", 0) == 0)
        throw InputError(command.name, ": ", option.name, " takes no value");
  }
}

/// \returns what is wrong with a value, as CLI11's validators do
std::string refusal(const Option& option, const std::string& value) {
  if (value.empty())
    return "the value is empty; " + option.value + " is needed";
  const auto& words = option.words;
  if (words.empty() || std::find(words.begin(), words.end(), value) != words.end())
    return "";
  return "unknown value '" + value + "'" + bem::suggestion(value, words);
}

void addOption(CLI::App& app, const Option& option) {
  if (option.value.empty()) {
    app.add_flag(option.name)->disable_flag_override();
    return;
  }
  app.add_option(option.name)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check([option](const std::string& value) { return refusal(option, value); });
}

}  // namespace

std::string Given::value(const std::string& option, const std::string& otherwise) const {
  const auto found = options.find(option);
  return found == options.end() || found->second.empty() ? otherwise
                                                         : found->second.back();
}

std::vector<std::string> Given::values(const std::string& option) const {
  const auto found = options.find(option);
  return found == options.end() ? std::vector<std::string>() : found->second;
}

std::vector<std::string> Given::words() const {
  std::vector<std::string> words;
  for (const auto& [name, values] : options) {
    if (values.empty())
      words.push_back(name);
    for (const std::string& value : values)
      words.push_back(name + "=" + value);
  }
  words.insert(words.end(), {"--", argument});
  return words;
}

Given parseArguments(const Command& command, const std::vector<std::string>& arguments) {
  checkForm(command, arguments);
  Given given;
  CLI::App app;
  app.set_help_flag();  // this program has its own --help
  app.add_flag("-h,--help")->disable_flag_override();
  if (!command.argument.name.empty())
    app.add_option(command.argument.name, given.argument);
  for (const Option& option : command.options)
    addOption(app, option);
  try {
    // CLI11 expects the reverse order
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> rest = app.remaining();
    refuse(command,
           *std::find_if(rest.begin(), rest.end(),
                         [](const auto& text) { return text != "--"; }),
           given.argument);
  } catch (const CLI::ParseError& error) {
    throw InputError(command.name, ": ", error.what(), "; usage: ", usageLine(command));
  }
  for (const CLI::Option* option : app.get_options())
    if (option->count() > 0 && option->nonpositional())
      given.options[option->get_name()] = option->get_items_expected() > 0
                                              ? option->results()
                                              : std::vector<std::string>();
  for (const Option& option : command.options)
    if (const auto values = given.values(option.name);
        values.size() > 1 && !option.repeatable)
      throw InputError(command.name, ": ", option.name, " is given ", values.size(),
                       " times; once is allowed");
  if (given.argument.empty() && command.argument.required &&
      !command.argument.name.empty() && !given.has("--help"))
    throw InputError(command.name, ": no ", command.argument.what,
                     " is given; usage: ", usageLine(command));
  return given;
}

int positiveNumber(const std::string& option, const std::string& text, int most) {
  const auto value = numberIn<int>(text);
  if (!value || *value < 1)
    throw InputError(option, ": '", text, "' is not a whole number >= 1");
  if (*value > most)
    throw InputError(option, " = ", *value, "; allowed: from 1 to ", most);
  return *value;
}

int threadsOf(const Given& given) {
  return given.has("--threads")
             ? positiveNumber("--threads", given.value("--threads"), mostThreads)
             : 0;
}

namespace {

std::string leftOf(const Option& option) {
  return option.name + (option.value.empty() ? "" : " " + option.value);
}

/// `text` in lines of at most `width`, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    if (column > indent && column + 1 + word.size() > width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

/// "  left        what it means"
std::string line(const std::string& left, const std::string& meaning,
                 std::size_t indent) {
  constexpr std::size_t column = 34;
  constexpr std::size_t width = 98;
  std::string text = std::string(indent, ' ') + left;
  text += text.size() + 2 > column ? "\n" + std::string(column, ' ')
                                   : std::string(column - text.size(), ' ');
  return text + wrapped(meaning, column, width) + "\n";
}

std::string optionLines(const Command& command, std::size_t indent) {
  std::string text;
  for (const Option& option : command.options)
    text += line(leftOf(option), meaningOf(option), indent);
  return text;
}

}  // namespace

std::string nameOf(const ExitMeaning& exit) {
  return std::to_string(exit.code) + exit.more;
}

std::string meaningOf(const Option& option) {
  return option.meaning + (option.repeatable ? "; repeatable" : "");
}

std::string usageLine(const Command& command) {
  const std::string& name = command.argument.name;
  std::string text = "epafi " + command.name;
  if (!name.empty())
    text += command.argument.required ? " " + name : " [" + name + "]";
  if (command.options.size() > 2)
    return text + " [options]";
  for (const Option& option : command.options)
    text += " [" + leftOf(option) + "]" + (option.repeatable ? "..." : "");
  return text;
}

std::string helpOf(const Command& command) {
  std::string text =
      "usage: " + usageLine(command) + "\n\n" + wrapped(command.purpose, 0, 98) + "\n";
  if (!command.options.empty())
    text += "\n" + optionLines(command, 2);
  return text;
}

std::string helpOf(const std::vector<Command>& commands) {
  std::string text = "Epafi: " + programTitle + "\n\n";
  for (const Command& command : commands)
    text += line(usageLine(command), command.purpose, 2) + optionLines(command, 6);
  text += line("epafi COMMAND --help", "the same of one command", 2) + "\nExit codes\n";
  for (const ExitMeaning& exit : exitCodes)
    text += line(nameOf(exit), exit.meaning, 2);
  return text;
}

std::string listOf(const std::vector<Command>& commands) {
  std::string text;
  for (const Command& command : commands)
    text += line(command.name, command.purpose, 2);
  return text;
}

}  // namespace epafi::drivers
