#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Command.hpp"
#include "drivers/commands/Help.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

using bem::InputError;

const Option help{"--help", "", "", Offer::Nothing, {}, true};

const Option& optionOf(const Command& command, const std::string& name) {
  std::vector<std::string> known;
  for (const Option& option : command.options) {
    if (option.name == name)
      return option;
    known.push_back(option.name);
  }
  known.push_back(help.name);
  if (name != help.name && name != "-h")
    throw InputError(command.name, ": unknown option '", name, "'",
                     bem::suggestion(name, known));
  return help;
}

void checkValues(const Command& command, const Option& option,
                 const std::vector<std::string>& values) {
  if (values.size() > 1 && !option.repeatable)
    throw InputError(command.name, ": ", option.name, " is given ", values.size(),
                     " times; once is allowed");
  for (const std::string& value : values) {
    if (value.empty())
      throw InputError(command.name, ": ", option.name, ": the value is empty; ",
                       option.value, " is needed");
    if (!option.words.empty() &&
        std::find(option.words.begin(), option.words.end(), value) == option.words.end())
      throw InputError(command.name, ": ", option.name, ": unknown ",
                       option.name.substr(2), " '", value, "'",
                       bem::suggestion(value, option.words));
  }
}

void takeArgument(const Command& command, const std::string& text, Given& given) {
  if (command.argument.name.empty())
    throw InputError(command.name, ": argument '", text,
                     "' is not understood; usage: ", usageLine(command));
  if (!given.argument.empty())
    throw InputError(command.name, ": two arguments, '", given.argument, "' and '", text,
                     "'; one ", command.argument.what, " is allowed");
  given.argument = text;
}

void requireArgument(const Command& command, const Given& given) {
  if (given.argument.empty() && !command.argument.name.empty() &&
      command.argument.required && !given.has(help.name))
    throw InputError(command.name, ": no ", command.argument.what,
                     " is given; usage: ", usageLine(command));
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

Given parseArguments(const Command& command, const std::vector<std::string>& arguments) {
  Given given;
  bool options = true;  // until --, behind which no word is one
  for (auto word = arguments.begin(); word != arguments.end(); ++word) {
    if (options && *word == "--") {
      options = false;
      continue;
    }
    if (!options || word->size() < 2 || word->front() != '-') {
      takeArgument(command, *word, given);
      continue;
    }
    const bool isLast = word + 1 == arguments.end();
    const std::size_t equals = word->find('=');
    const bool without = equals == std::string::npos;
    const Option& option = optionOf(command, word->substr(0, equals));
    std::vector<std::string>& values = given.options[option.name];
    if (option.value.empty() && !without)
      throw InputError(command.name, ": ", option.name, " takes no value");
    if (option.value.empty())
      continue;
    if (isLast && (without || equals + 1 == word->size()))
      throw InputError(command.name, ": ", option.name, " needs a value: ", option.name,
                       " ", option.value);
    values.push_back(without ? *++word : word->substr(equals + 1));
  }
  for (const Option& option : command.options)
    checkValues(command, option, given.values(option.name));
  requireArgument(command, given);
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

}  // namespace epafi::drivers
