#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ChildProgram.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>
#include <functional>
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

/// A value that the type accepts, for a key without a default.
std::string sample(const Parameter& row) {
  if (!row.defaultValue.empty())
    return row.defaultValue;
  if (!row.allowed.empty())
    return row.kind == Kind::Names ? "{" + row.allowed.front() + "}"
                                   : row.allowed.front();
  return textOf(row.kind).sample;
}

/// A list that Teuchos can read: every key, with its default or a sample value.
std::string xml(const bem::SchemaRows& rows) {
  std::ostringstream out;
  const std::function<void(const std::string&, const std::string&)> write =
      [&](const std::string& parent, const std::string& indent) {
        for (const Parameter* child : childrenOf(rows, parent)) {
          const Parameter& row = *child;
          // Two hyphens in a row would end the comment.
          out << indent << "<!-- " << remarks(row)
              << (row.range().empty() ? "" : "; " + row.range());
          if (!isList(row))
            out << "; default: " << standardOf(row);
          out << " -->\n";
          const std::string name = xmlText(row.name());
          if (isList(row)) {
            out << indent << "<ParameterList name=\"" << name << "\">\n";
            write(row.path, indent + "  ");
            out << indent << "</ParameterList>\n";
          } else {
            out << indent << "<Parameter name=\"" << name << "\" type=\""
                << textOf(row.kind).type << "\" value=\"" << xmlText(sample(row))
                << "\"/>\n";
          }
        }
      };
  out << "<ParameterList name=\"Parameters\">\n";
  write("", "  ");
  out << "</ParameterList>\n";
  return out.str();
}

}  // namespace

std::vector<Grammar> grammars(const std::string& name) {
  const Grammar scene{"scene", &parameters()};
  const Grammar study{"study", &studyParameters()};
  return name.empty() ? std::vector<Grammar>{scene, study}
                      : std::vector<Grammar>{name == scene.name ? scene : study};
}

std::string parametersText(const std::vector<Grammar>& grammars,
                           const std::string& format) {
  if (format == "xml")
    return xml(*grammars.front().rows);
  std::string text;
  for (const Grammar& grammar : grammars) {
    if (grammars.size() > 1)
      text += (text.empty() ? "A " : "\nA ") + grammar.name + "\n\n";
    text += plainText(*grammar.rows);
  }
  return text;
}

std::string madeWithProgram(const std::string& file) {
  const std::string path = besideProgram("share/" + file);
  if (!std::filesystem::exists(path))
    throw bem::InputError("'", path,
                          "' is missing; it is built and installed along with epafi");
  return readText(path);
}

int parametersCommand(const Given& given, std::ostream& out) {
  const std::vector<Grammar> wanted = grammars(given.value("--of"));
  const std::string format = given.value("--format", "text");
  if (format == "markdown")
    for (const Grammar& grammar : wanted)
      out << (&grammar == &wanted.front() ? "" : "\n")
          << madeWithProgram("epafi/parameters/" + grammar.name + ".md");
  else
    out << parametersText(wanted, format);
  return 0;
}

int schemaCommand(const Given& given, std::ostream& out) {
  out << madeWithProgram("epafi/schema/" + given.value("--of", "epafi") + "." +
                         given.value("--format", "rng"));
  return 0;
}

}  // namespace epafi::drivers
