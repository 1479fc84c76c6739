#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"

#include <cmath>
#include <ostream>
#include <sstream>

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

std::string listed(const std::vector<std::string>& words) {
  std::string text = "[";
  for (const std::string& word : words)
    text += (text.size() == 1 ? "" : ", ") + quoted(word);
  return text + "]";
}

std::string limits(const bem::Interval& interval) {
  std::string text;
  if (std::isfinite(interval.low))
    text += std::string(", ") +
            (interval.lowOpen ? "\"exclusiveMinimum\": " : "\"minimum\": ") +
            bem::message(interval.low);
  if (std::isfinite(interval.high))
    text += std::string(", ") +
            (interval.highOpen ? "\"exclusiveMaximum\": " : "\"maximum\": ") +
            bem::message(interval.high);
  return text;
}

/// The type of a value, and what it may be.
std::string typeOf(const Parameter& row) {
  const std::string words =
      row.allowed.empty() ? "" : ", \"enum\": " + listed(row.allowed);
  switch (row.kind) {
    case Kind::Real:
      return "\"type\": \"number\"" + limits(row.interval);
    case Kind::Whole:
      return "\"type\": \"integer\"" + limits(row.interval);
    case Kind::Flag:
      return "\"type\": \"boolean\"";
    case Kind::Text:
      return "\"type\": \"string\"" + words;
    case Kind::Expression:
      return "\"type\": [\"string\", \"number\"]";
    case Kind::Names:
      return "\"type\": \"array\", \"items\": {\"type\": \"string\"" + words + "}";
    case Kind::Counts:
      return "\"type\": [\"array\", \"integer\"], \"items\": {\"type\": \"integer\"" +
             limits(row.interval) + "}" + limits(row.interval);
    case Kind::Reals:
      return "\"type\": [\"array\", \"number\"], \"items\": {\"type\": \"number\"" +
             limits(row.interval) + "}" + limits(row.interval);
    case Kind::Points:
      return "\"type\": \"array\", \"items\": {\"type\": \"array\", \"minItems\": 2, "
             "\"maxItems\": 2, \"items\": {\"type\": \"number\"}}";
    case Kind::List:
    case Kind::Free:
      break;
  }
  return "\"type\": \"object\"";
}

class Writer {
 public:
  Writer(const bem::SchemaRows& rows, std::ostream& out) : rows_(rows), out_(out) {}

  /// What an object at `parent` holds, without its own braces.
  void content(const std::string& parent, const std::string& indent) {
    std::vector<std::string> required;
    std::vector<const Parameter*> literal;
    std::vector<const Parameter*> patterns;
    for (const Parameter* row : childrenOf(rows_, parent)) {
      (row->name().find('<') == std::string::npos ? literal : patterns).push_back(row);
      if (row->required && row->only.empty())
        required.push_back(row->name());
    }
    out_ << "\"type\": \"object\", \"additionalProperties\": false";
    if (!required.empty())
      out_ << ", \"required\": " << listed(required);
    group("properties", literal, indent);
    group("patternProperties", patterns, indent);
  }

 private:
  static std::string keyOf(const Parameter& row) {
    const std::string name = row.name();
    if (name.front() == '<')
      return "^.+$";
    const auto k = name.find("<k>");
    return k == std::string::npos
               ? name
               : "^" + name.substr(0, k) + "[1-9][0-9]*" + name.substr(k + 3) + "$";
  }

  void group(const std::string& name, const std::vector<const Parameter*>& rows,
             const std::string& indent) {
    if (rows.empty())
      return;
    out_ << ",\n" << indent << quoted(name) << ": {";
    const char* separator = "\n";
    for (const Parameter* row : rows) {
      out_ << separator << indent << "  " << quoted(keyOf(*row)) << ": {\"description\": "
           << quoted(row->meaning + (row->unit.empty() ? "" : " [" + row->unit + "]"))
           << ", ";
      if (row->kind == Kind::List)
        content(row->path, indent + "    ");
      else
        out_ << typeOf(*row);
      out_ << "}";
      separator = ",\n";
    }
    out_ << "\n" << indent << "}";
  }

  const bem::SchemaRows& rows_;
  std::ostream& out_;
};

}  // namespace

std::string jsonSchema(const std::vector<Grammar>& grammars) {
  std::ostringstream out;
  out << "{\n  \"$schema\": \"http://json-schema.org/draft-07/schema#\",\n"
         "  \"title\": \"Epafi\",\n"
         "  \"$comment\": \"names, types, words and ranges; what depends on other keys, "
         "and what is required because of them, `epafi check` knows\",\n"
         "  \"type\": \"object\", \"minProperties\": 1, \"maxProperties\": 1,\n"
         "  \"additionalProperties\": ";
  const auto object = [&out](const Grammar& grammar) {
    out << "{\"title\": " << quoted("a " + grammar.name) << ", ";
    Writer(*grammar.rows, out).content("", "      ");
    out << "}";
  };
  if (grammars.size() == 1) {  // alone: editors then say what is wrong where
    object(grammars.front());
  } else {
    const char* separator = "{\"anyOf\": [\n    ";
    for (const Grammar& grammar : grammars) {
      out << separator;
      object(grammar);
      separator = ",\n    ";
    }
    out << "\n  ]}";
  }
  out << "\n}\n";
  return out.str();
}

}  // namespace epafi::drivers
