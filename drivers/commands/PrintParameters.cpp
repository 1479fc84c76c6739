#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"
#include "drivers/study/Study.hpp"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <functional>
#include <ostream>
#include <sstream>

namespace epafi::drivers {

namespace {

std::string markdownText(std::string text) {
  constexpr std::pair<const char*, const char*> signs[] = {
      {"|", "\\|"}, {"<", "&lt;"}, {">", "&gt;"}, {"*", "\\*"}};
  for (const auto& [sign, replacement] : signs)
    boost::algorithm::replace_all(text, sign, replacement);
  return text;
}

bool isList(const Parameter& row) {
  return row.kind == Kind::List || row.kind == Kind::Free;
}

/// A list that is not required may be left out: its keys then have their defaults.
std::string standardOf(const Parameter& row) {
  if (row.required)
    return "required";
  if (isList(row))
    return "may be left out";
  return row.standard.empty() ? "none" : row.standard;
}

std::string typeOf(const Parameter& row) {
  const std::string type = textOf(row.kind).type;
  return row.kind == Kind::Expression ? type + ": expression in x, y" : type;
}

/// "only with Law 'Tresca'"
std::string restriction(const Parameter& row) {
  if (row.only.empty())
    return "";
  const bool friction = boost::algorithm::ends_with(row.parent(), "Friction");
  return bem::message("only with ", friction ? "Law" : "Type", " ",
                      bem::quotedList(row.only));
}

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

/// One table per list.
std::string markdown(const Grammar& grammar) {
  const bem::SchemaRows& rows = *grammar.rows;
  std::ostringstream out;
  out << "# Parameters of a " << grammar.name << "\n\n"
      << "Written by `epafi parameters --format markdown`.  `<body>` and the like stand "
         "for names of your choice,\n`<k>` for 1, 2, ...\n";
  const auto table = [&](const std::string& parent) {
    out << "\n| key | type | default | range | meaning | unit "
           "|\n|---|---|---|---|---|---|\n";
    for (const Parameter* row : childrenOf(rows, parent)) {
      const std::string only = restriction(*row);
      out << "| " << markdownText(row->name()) << " | " << typeOf(*row) << " | "
          << markdownText(standardOf(*row)) << " | " << markdownText(row->range())
          << " | " << markdownText(row->meaning + (only.empty() ? "" : "; " + only))
          << " | " << row->unit << " |\n";
    }
  };
  out << "\n## The " << grammar.name << "\n";
  table("");
  for (const Parameter& list : rows)
    if (list.kind == Kind::List) {
      out << "\n## " << markdownText(list.path) << "\n\n"
          << markdownText(remarks(list)) << "\n";
      table(list.path);
    }
  return out.str();
}

/// A value that the type accepts, for a key without a default.
std::string sample(const Parameter& row) {
  if (!row.standard.empty())
    return row.standard;
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
    text += text.empty() ? "" : "\n";
    if (format == "markdown")
      text += markdown(grammar);
    else
      text += (grammars.size() == 1 ? "" : "A " + grammar.name + "\n\n") +
              plainText(*grammar.rows);
  }
  return text;
}

int parametersCommand(const Given& given, std::ostream& out) {
  out << parametersText(grammars(given.value("--of")), given.value("--format", "text"));
  return 0;
}

int schemaCommand(const Given& given, std::ostream& out) {
  const std::vector<Grammar> wanted = grammars(given.value("--of"));
  out << (given.value("--format", "rng") == "rng" ? relaxNg(wanted) : jsonSchema(wanted));
  return 0;
}

}  // namespace epafi::drivers
