#include "bem/base/SchemaRow.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <algorithm>
#include <boost/algorithm/string/finder.hpp>
#include <boost/algorithm/string/iter_find.hpp>
#include <cmath>

namespace epafi::bem {

bool Interval::contains(double value) const {
  return (lowOpen ? value > low : value >= low) &&
         (highOpen ? value < high : value <= high);
}

std::string Interval::text() const {
  if (std::isinf(high) && std::isinf(low))
    return "any finite number";
  if (std::isinf(high))
    return message(lowOpen ? "> " : ">= ", low);
  if (std::isinf(low))
    return message(highOpen ? "< " : "<= ", high);
  if (!lowOpen && !highOpen)
    return message("from ", low, " to ", high);
  return message("in ", lowOpen ? "(" : "[", low, ", ", high, highOpen ? ")" : "]");
}

const KindText& textOf(Kind kind) {
  static constexpr KindText table[] = {
      // in the order of Kind
      {"double", "double", "a number (double)", "0.25"},
      {"int", "int", "a whole number (int)", "0"},
      {"bool", "bool", "true or false (bool)", "0"},
      {"string", "string", "string", "0"},
      {"string", "string", "an expression (string)", "0"},
      {"string", "Array(string)", "a list of names, also of one (Array(string))",
       "{bottom, right, left}"},
      {"int", "Array(int)", "Array(int)", "{1, 1, 1}"},
      {"double", "Array(double)", "a list of numbers (Array(double))", "{0, 0, 0.5}"},
      {"double", "TwoDArray(double)",
       "a table n x 2 of numbers (TwoDArray(double)), [[0, 0], [1, 0], ...] in YAML",
       "3x2:{0, 0, 1, 0, 0, 1}"},
      {"", "ParameterList", "ParameterList", ""},
      {"", "ParameterList", "ParameterList", ""}};
  return table[static_cast<std::size_t>(kind)];
}

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + arrow + name;
}

std::vector<std::string> namesOf(const std::string& path) {
  std::vector<std::string> names;
  return boost::algorithm::iter_split(names, path, boost::algorithm::first_finder(arrow));
}

std::string SchemaRow::parent() const {
  const auto at = path.rfind(arrow);
  return at == std::string::npos ? "" : path.substr(0, at);
}

std::string lastOf(const std::string& path) { return namesOf(path).back(); }

std::string SchemaRow::range() const {
  if (!allowed.empty())
    return quotedList(allowed);
  if (kind == Kind::Real || kind == Kind::Whole || kind == Kind::Counts ||
      kind == Kind::Reals)
    return interval.text();
  return "";
}

std::vector<const SchemaRow*> childrenOf(const SchemaRows& table,
                                         const std::string& parent) {
  std::vector<const SchemaRow*> rows;
  for (const SchemaRow& row : table)
    if (row.parent() == parent)
      rows.push_back(&row);
  return rows;
}

std::string placesOf(const SchemaRows& table, const std::string& name) {
  std::vector<std::string> places;
  bool isOfRoot = false;
  for (const SchemaRow& row : table) {
    if (row.name() != name)
      continue;
    isOfRoot = isOfRoot || row.parent().empty();
    if (!row.parent().empty() &&
        std::find(places.begin(), places.end(), row.parent()) == places.end())
      places.push_back(row.parent());
  }
  return places.empty() ? isOfRoot ? "; it belongs to the root, beside 'Bodies'" : ""
                        : "; it belongs to " + quotedList(places);
}

void append(SchemaRows& table, const SchemaRows& rows, const std::string& parent) {
  for (SchemaRow row : rows) {
    row.path = join(parent, row.path);
    const auto other =
        std::find_if(table.begin(), table.end(),
                     [&row](const SchemaRow& known) { return known.path == row.path; });
    if (other == table.end()) {
      table.push_back(std::move(row));
      continue;
    }
    if (other->only.empty() || row.only.empty() || other->kind != row.kind ||
        other->unit != row.unit || other->defaultValue != row.defaultValue ||
        other->required != row.required || other->range() != row.range())
      throw InputError(row.path, ": two keys of this name that differ");
    if (other->meaning != row.meaning)
      other->meaning += "; " + quotedList(row.only) + ": " + row.meaning;
    other->only.insert(other->only.end(), row.only.begin(), row.only.end());
  }
}

}  // namespace epafi::bem
