#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ExitCode.hpp"

#include <cmath>

namespace epafi::drivers {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += '\\';
    result += c;
  }
  return result + "\"";
}

using Members = std::vector<std::pair<std::string, std::string>>;

std::string object(const Members& members) {
  std::string text;
  for (const auto& [name, value] : members)
    text += (text.empty() ? "{" : ", ") + quoted(name) + ": " + value;
  return text.empty() ? "{}" : text + "}";
}

template <class Range, class Each>
std::string array(const Range& range, Each each) {
  std::string text;
  for (const auto& item : range)
    text += (text.empty() ? "[" : ",\n") + each(item);
  return text.empty() ? "[]" : text + "]";
}

std::string limits(const bem::Interval& interval) {
  Members members;
  if (std::isfinite(interval.low))
    members.emplace_back(interval.lowOpen ? "exclusiveMinimum" : "minimum",
                         bem::message(interval.low));
  if (std::isfinite(interval.high))
    members.emplace_back(interval.highOpen ? "exclusiveMaximum" : "maximum",
                         bem::message(interval.high));
  return object(members);
}

std::string keyAsJson(const Parameter& row) {
  return object({{"path", quoted(row.path)},
                 {"type", quoted(typeOf(row))},
                 {"free", row.kind == Kind::Free ? "true" : "false"},
                 {"required", row.required ? "true" : "false"},
                 {"default", quoted(standardOf(row))},
                 {"sample", quoted(textOf(row.kind).sample)},
                 {"range", quoted(row.range())},
                 {"limits", limits(row.interval)},
                 {"allowed", array(row.allowed, quoted)},
                 {"only", quoted(restriction(row))},
                 {"meaning", quoted(row.meaning)},
                 {"unit", quoted(row.unit)}});
}

std::string optionAsJson(const Option& option) {
  return object({{"name", quoted(option.name)},
                 {"value", quoted(option.value)},
                 {"meaning", quoted(meaningOf(option))},
                 {"words", array(option.words, quoted)}});
}

std::string commandAsJson(const Command& command) {
  return object({{"name", quoted(command.name)},
                 {"usage", quoted(usageLine(command))},
                 {"purpose", quoted(command.purpose)},
                 {"argument", quoted(command.argument.name)},
                 {"options", array(command.options, optionAsJson)}});
}

std::string exitAsJson(const ExitMeaning& exit) {
  return object({{"code", quoted(nameOf(exit))}, {"meaning", quoted(exit.meaning)}});
}

}  // namespace

std::string description(const std::vector<Command>& commands) {
  Members keys;
  for (const Grammar& grammar : grammars())
    keys.emplace_back(grammar.name, array(*grammar.rows, keyAsJson));
  return object({{"title", quoted(title)},
                 {"commands", array(commands, commandAsJson)},
                 {"exit codes", array(exitCodes, exitAsJson)},
                 {"keys", object(keys)}}) +
         "\n";
}

}  // namespace epafi::drivers
