#include "bem/base/SchemaRow.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parameters.hpp"

#include <algorithm>
#include <charconv>

namespace epafi::bem {

namespace {

const std::string arrow = "->";

}  // namespace

std::string typeName(Kind kind) {
  switch (kind) {
    case Kind::Real:
      return "double";
    case Kind::Whole:
      return "int";
    case Kind::Flag:
      return "bool";
    case Kind::Text:
    case Kind::Expression:
      return "string";
    case Kind::Names:
      return "Array(string)";
    case Kind::Counts:
      return "Array(int)";
    case Kind::Reals:
      return "Array(double)";
    case Kind::Points:
      return "TwoDArray(double)";
    case Kind::List:
    case Kind::Free:
      break;
  }
  return "ParameterList";
}

Row& Row::standard(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return standard(std::string(text, end.ptr));
}

std::string SchemaRow::parent() const {
  const auto at = path.rfind(arrow);
  return at == std::string::npos ? "" : path.substr(0, at);
}

std::string SchemaRow::name() const {
  const auto at = path.rfind(arrow);
  return at == std::string::npos ? path : path.substr(at + arrow.size());
}

std::string SchemaRow::range() const {
  if (!allowed.empty())
    return quotedList(allowed);
  if (kind == Kind::Real || kind == Kind::Whole || kind == Kind::Counts ||
      kind == Kind::Reals)
    return interval.text();
  return "";
}

void append(SchemaRows& table, const SchemaRows& rows, const std::string& parent) {
  for (SchemaRow row : rows) {
    if (!parent.empty())
      row.path = parent + arrow + row.path;
    const auto other =
        std::find_if(table.begin(), table.end(),
                     [&row](const SchemaRow& known) { return known.path == row.path; });
    if (other == table.end()) {
      table.push_back(std::move(row));
      continue;
    }
    if (other->only.empty() || row.only.empty() || other->kind != row.kind ||
        other->unit != row.unit || other->standard != row.standard ||
        other->required != row.required || other->range() != row.range())
      throw InputError(message(row.path, ": two keys of this name that differ"));
    if (other->meaning != row.meaning)
      other->meaning += "; " + quotedList(row.only) + ": " + row.meaning;
    other->only.insert(other->only.end(), row.only.begin(), row.only.end());
  }
}

}  // namespace epafi::bem
