#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ChildProgram.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"
#include "drivers/study/Study.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <ostream>

namespace epafi::drivers {

std::string standardOf(const Parameter& row) {
  if (row.required)
    return "required";
  if (row.kind == Kind::List || row.kind == Kind::Free)
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

std::vector<Grammar> grammars() {
  return {{"scene", &parameters()}, {"study", &studyParameters()}};
}

std::string madeWithProgram(const std::string& file) {
  const std::string path = besideProgram("share/" + file);
  if (!std::filesystem::exists(path))
    throw bem::InputError("'", path,
                          "' is missing; it is built and installed along with epafi");
  return readText(path);
}

int parametersCommand(const Given& given, std::ostream& out) {
  const std::string format = given.value("--format", "text");
  const std::string of = given.value("--of", format == "xml" ? "scene" : "epafi");
  out << madeWithProgram("epafi/parameters/" + of +
                         (format == "text"  ? ".txt"
                          : format == "xml" ? ".xml"
                                            : ".md"));
  return 0;
}

int schemaCommand(const Given& given, std::ostream& out) {
  out << madeWithProgram("epafi/schema/" + given.value("--of", "epafi") + "." +
                         given.value("--format", "rng"));
  return 0;
}

}  // namespace epafi::drivers
