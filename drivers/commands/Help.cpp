#include "drivers/commands/Command.hpp"
#include "drivers/process/ExitCode.hpp"

#include <sstream>

namespace epafi::drivers {

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
  std::string text = "Epafi: " + title + "\n\n";
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
