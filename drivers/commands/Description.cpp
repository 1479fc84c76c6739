#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/ContactTable.hpp"
#include "drivers/output/HistoryTables.hpp"
#include "drivers/output/TrueError.hpp"
#include "drivers/process/ChildProgram.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

bool isList(const Parameter& row) {
  return row.kind == Kind::List || row.kind == Kind::Free;
}

}  // namespace

std::string standardOf(const Parameter& row) {
  if (row.required)
    return "required";
  if (isList(row))
    return "may be left out";
  return row.defaultValue.empty() ? "none" : row.defaultValue;
}

std::string typeOf(const Parameter& row) {
  const std::string type = textOf(row.kind).type;
  return row.kind == Kind::Expression ? type + ": expression" : type;
}

std::string restriction(const Parameter& row) {
  if (row.only.empty())
    return "";
  const std::string parent = row.parent();
  const bool isLaw = boost::algorithm::ends_with(parent, "Friction") ||
                     boost::algorithm::ends_with(parent, "Normal");
  return bem::message("only with ", isLaw ? "Law" : "Type", " ",
                      bem::quotedList(row.only));
}

namespace {

std::string remarks(const Parameter& row) {
  std::string text = row.meaning;
  if (!row.unit.empty())
    text += " [" + row.unit + "]";
  if (!restriction(row).empty())
    text += "; " + restriction(row);
  return text;
}

std::string plainText(const bem::SchemaRows& rows) {
  std::ostringstream out;
  for (const Parameter& row : rows) {
    out << row.path << "\n    " << typeOf(row) << (isList(row) ? ", " : ", default: ")
        << standardOf(row);
    if (!row.range().empty())
      out << ", range: " << row.range();
    out << "\n    " << remarks(row) << "\n";
  }
  return out.str();
}

}  // namespace

std::vector<Grammar> grammars(const std::string& name) {
  const Grammar scene{"scene", &parameters()};
  const Grammar study{"study", &studyParameters()};
  return name.empty() ? std::vector<Grammar>{scene, study}
                      : std::vector<Grammar>{name == scene.name ? scene : study};
}

std::string madeWithProgram(const std::string& file) {
  const std::string path = besideProgram("share/" + file);
  if (!std::filesystem::exists(path))
    throw bem::InputError("'", path,
                          "' is missing; it is built and installed along with epafi");
  return readText(path);
}

int parametersCommand(const Given& given, std::ostream& out) {
  std::vector<Grammar> wanted = grammars(given.value("--of"));
  const std::string format = given.value("--format", "text");
  if (format == "xml")
    wanted.resize(1);
  for (const Grammar& grammar : wanted) {
    out << (&grammar == &wanted.front() ? "" : "\n");
    if (format == "text")
      out << (wanted.size() > 1 ? "A " + grammar.name + "\n\n" : "")
          << plainText(*grammar.rows);
    else
      out << madeWithProgram("epafi/parameters/" + grammar.name +
                             (format == "xml" ? ".xml" : ".md"));
  }
  return 0;
}

int schemaCommand(const Given& given, std::ostream& out) {
  out << madeWithProgram("epafi/schema/" + given.value("--of", "epafi") + "." +
                         given.value("--format", "rng"));
  return 0;
}

namespace {

using Members = std::vector<std::pair<std::string, std::string>>;

std::string object(const Members& members) {
  std::string text;
  for (const auto& [name, value] : members)
    text += (text.empty() ? "{" : ", ") + jsonText(name) + ": " + value;
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
  return object({{"path", jsonText(row.path)},
                 {"type", jsonText(typeOf(row))},
                 {"free", row.kind == Kind::Free ? "true" : "false"},
                 {"required", row.required ? "true" : "false"},
                 {"default", jsonText(standardOf(row))},
                 {"sample", jsonText(textOf(row.kind).sample)},
                 {"range", jsonText(row.range())},
                 {"limits", limits(row.interval)},
                 {"allowed", array(row.allowed, jsonText)},
                 {"only", jsonText(restriction(row))},
                 {"meaning", jsonText(row.meaning)},
                 {"unit", jsonText(row.unit)}});
}

std::string optionAsJson(const Option& option) {
  return object({{"name", jsonText(option.name)},
                 {"value", jsonText(option.value)},
                 {"meaning", jsonText(meaningOf(option))},
                 {"words", array(option.words, jsonText)}});
}

std::string commandAsJson(const Command& command) {
  return object({{"name", jsonText(command.name)},
                 {"usage", jsonText(usageLine(command))},
                 {"purpose", jsonText(command.purpose)},
                 {"argument", jsonText(command.argument.name)},
                 {"options", array(command.options, optionAsJson)}});
}

std::string columnAsJson(const Cell& cell) {
  return object({{"name", jsonText(cell.name)},
                 {"meaning", jsonText(cell.meaning)},
                 {"unit", jsonText(cell.unit)}});
}

/// All columns of all files.
Members columns() {
  LevelRow level;
  level.contacts.emplace_back("<contact>", contact::Summary());
  Cells history = cellsOf(level);
  append(history, errorColumns());
  append(history, eigenvalueColumn());
  StepRow step;
  step.contacts = level.contacts;
  step.rigid.emplace_back("<body>", contact::Summary());
  ContactHistory path;
  BoundaryRow boundary;
  path.around = boundary.around = 0;
  Members files;
  for (const auto& [name, cells] : std::vector<std::pair<std::string, Cells>>{
           {"history.csv", history},
           {"contact.csv", cellsOf(ContactRow(), path)},
           {"boundary.csv", cellsOf(boundary)},
           {"fields.csv", columnsOfFields()},
           {"bodies.csv", cellsOf(StepRow(), "", contact::Summary())},
           {"steps.csv", cellsOf(step)}})
    files.emplace_back(name, array(cells, columnAsJson));
  return files;
}

std::string exitAsJson(const ExitMeaning& exit) {
  return object({{"code", jsonText(nameOf(exit))}, {"meaning", jsonText(exit.meaning)}});
}

}  // namespace

std::string description(const std::vector<Command>& commands) {
  Members keys;
  for (const Grammar& grammar : grammars())
    keys.emplace_back(grammar.name, array(*grammar.rows, keyAsJson));
  return object({{"title", jsonText(programTitle)},
                 {"commands", array(commands, commandAsJson)},
                 {"exit codes", array(exitCodes, exitAsJson)},
                 {"keys", object(keys)},
                 {"columns", object(columns())}}) +
         "\n";
}

}  // namespace epafi::drivers
