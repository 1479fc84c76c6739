#include "bem/base/Schema.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace epafi::bem {

namespace {

using Teuchos::Array;
using Teuchos::getValue;
using Teuchos::ParameterEntry;
using Teuchos::ParameterList;
using Teuchos::TwoDArray;
using Texts = std::vector<std::string>;

/// What an entry holds: one value, those of an array or, row by row, of a table.
struct Cells {
  enum class Shape { Other, One, Array, Table } shape = Shape::Other;
  std::variant<std::vector<int>, std::vector<double>, Texts> values;
  int rows = 1;
  int columns = 1;

  template <class T>
  bool take(const ParameterEntry& entry) {
    if (entry.isType<T>())
      *this = {Shape::One, std::vector<T>{getValue<T>(entry)}};
    else if (entry.isType<Array<T>>())
      *this = {Shape::Array, getValue<Array<T>>(entry).toVector()};
    else if (entry.isType<TwoDArray<T>>()) {
      const auto& table = getValue<TwoDArray<T>>(entry);
      *this = {Shape::Table, table.getDataArray().toVector(),
               static_cast<int>(table.getNumRows()),
               static_cast<int>(table.getNumCols())};
    }
    return shape != Shape::Other;
  }
};

/// Of flags and lists nothing.
Cells cellsOf(const ParameterEntry& entry) {
  Cells cells;
  if (!cells.take<int>(entry) && !cells.take<double>(entry))
    cells.take<std::string>(entry);
  return cells;
}

std::string spell(int value) { return std::to_string(value); }
std::string spell(double value) { return shortest(value); }
std::string spell(const std::string& value) { return value; }

std::string describe(const ParameterEntry& entry) {
  if (entry.isList())
    return "a sublist";
  return entry.isType<std::string>() ? "the string '" + getValue<std::string>(entry) + "'"
                                     : "of type " + entry.getAny(false).typeName();
}

/// The default of a row, marked as default.  \pre the row has one
ParameterEntry defaultOf(const SchemaRow& row) {
  switch (row.kind) {
    case Kind::Real:
      return ParameterEntry(std::stod(row.defaultValue), true);
    case Kind::Whole:
      return ParameterEntry(std::stoi(row.defaultValue), true);
    case Kind::Flag:
      return ParameterEntry(row.defaultValue == "true", true);
    default:
      return ParameterEntry(row.defaultValue, true);
  }
}

/// Makes of what a list holds at a place the value that a row declares.
class Conversion {
 public:
  Conversion(const ParameterEntry& entry, const SchemaRow& row, const std::string& place,
             const Constant& constant)
      : entry_(entry),
        cells_(cellsOf(entry)),
        row_(row),
        place_(place),
        constant_(constant) {}

  /// \throws InputError, beginning with the place, for a wrong type or a value out of range
  ParameterEntry checked() const {
    ParameterEntry result = converted();
    const Cells cells = cellsOf(result);
    std::visit(
        [this](const auto& values) {
          for (const auto& value : values)
            check(value);
        },
        cells.values);
    if (row_.kind == Kind::Points && cells.columns != 2)
      throw InputError(place_, ": a point has 2 coordinates, the table has ",
                       cells.columns, " columns");
    // a default that used.xml tells apart from what the user wrote remains one
    const Teuchos::any value = result.getAny(false);
    if (entry_.isDefault() && !row_.defaultValue.empty() &&
        value == defaultOf(row_).getAny(false))
      result.setAnyValue(value, true);
    return result;
  }

 private:
  ParameterEntry converted() const {
    const bool one = cells_.shape == Cells::Shape::One;
    const bool row = one || cells_.shape == Cells::Shape::Array;
    const bool texts = std::holds_alternative<Texts>(cells_.values);
    switch (row_.kind) {
      case Kind::Real:
        return one ? ParameterEntry(numbers<double>().front()) : throw refusal();
      case Kind::Whole:
        return one ? ParameterEntry(numbers<int>().front()) : throw refusal();
      case Kind::Reals:
        return row ? ParameterEntry(Array<double>(numbers<double>())) : throw refusal();
      case Kind::Counts:
        return row ? ParameterEntry(Array<int>(numbers<int>())) : throw refusal();
      case Kind::Points:
        return cells_.shape == Cells::Shape::Table ? table() : throw refusal();
      case Kind::Text:
        return one && texts ? ParameterEntry(spelled().front()) : throw refusal();
      case Kind::Expression:
        return one ? ParameterEntry(spelled().front()) : throw refusal();
      case Kind::Names:  // numbers count as their texts
        return row && (texts ? !one : !spelled().empty())
                   ? ParameterEntry(Array<std::string>(spelled()))
                   : throw refusal();
      default:  // a flag: lists do not come here
        return entry_.isType<bool>() ? ParameterEntry(getValue<bool>(entry_))
                                     : throw refusal();
    }
  }

  InputError refusal() const {
    constexpr int largest = std::numeric_limits<int>::max();
    const auto* reals = std::get_if<std::vector<double>>(&cells_.values);
    const bool tooLarge =
        (row_.kind == Kind::Whole || row_.kind == Kind::Counts) && reals != nullptr &&
        std::any_of(reals->begin(), reals->end(), [&](double x) { return x > largest; });
    return InputError(place_, ": is ", describe(entry_), tooLarge ? " and too large" : "",
                      ", wanted: ", textOf(row_.kind).wanted,
                      tooLarge ? message(" up to ", largest) : "");
  }

  /// No fractions for whole numbers; of texts the values of constant expressions.
  template <class Number>
  std::vector<Number> numbers() const {
    if (const auto* whole = std::get_if<std::vector<int>>(&cells_.values))
      return {whole->begin(), whole->end()};
    if (const auto* same = std::get_if<std::vector<Number>>(&cells_.values))
      return *same;
    if (!constant_ || !std::holds_alternative<Texts>(cells_.values))
      throw refusal();
    std::vector<Number> result;
    for (const std::string& text : std::get<Texts>(cells_.values))
      result.push_back(static_cast<Number>(evaluated(text)));
    return result;
  }

  double evaluated(const std::string& text) const {
    try {
      const double value = constant_(text, place_);
      constexpr double largest = std::numeric_limits<int>::max();
      const bool whole = row_.kind == Kind::Whole || row_.kind == Kind::Counts;
      if (whole && (value != std::round(value) || std::abs(value) > largest))
        throw InputError(place_, " = '", text, "' is ", shortest(value));
      return value;
    } catch (const InputError& error) {
      throw InputError(error.what(), "; wanted: ", textOf(row_.kind).wanted,
                       ", or an expression in Constants for each number");
    }
  }

  ParameterEntry table() const {
    const std::vector<double> values = numbers<double>();
    TwoDArray<double> table(cells_.rows, cells_.columns);
    for (std::size_t i = 0; i < values.size(); ++i)
      table(static_cast<int>(i) / cells_.columns, static_cast<int>(i) % cells_.columns) =
          values[i];
    return ParameterEntry(table);
  }

  Texts spelled() const {
    Texts result;
    std::visit(
        [&result](const auto& values) {
          for (const auto& value : values)
            result.push_back(spell(value));
        },
        cells_.values);
    return result;
  }

  void check(double number) const {
    if (!row_.interval.contains(number) || !std::isfinite(number))
      throw InputError(place_, " = ", shortest(number),
                       "; allowed: ", row_.interval.text());
  }

  void check(const std::string& text) const {
    const Texts& names = row_.allowed;
    if (!names.empty() && std::find(names.begin(), names.end(), text) == names.end())
      throw InputError(place_, " = '", text, "'", meant(text, names),
                       "; allowed: ", quotedList(names));
  }

  const ParameterEntry& entry_;
  const Cells cells_;
  const SchemaRow& row_;
  const std::string& place_;
  const Constant& constant_;
};

bool isAnyName(const std::string& pattern) { return pattern.front() == '<'; }

bool isCount(const std::string& text) {
  return !text.empty() && text.size() < 7 && text.front() != '0' &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

bool matches(const std::string& pattern, const std::string& name) {
  if (isAnyName(pattern))
    return true;
  const auto k = pattern.find("<k>");
  if (k == std::string::npos)
    return pattern == name;
  const std::string before = pattern.substr(0, k);
  const std::string after = pattern.substr(k + 3);
  return name.size() > before.size() + after.size() &&
         name.compare(0, before.size(), before) == 0 &&
         name.compare(name.size() - after.size(), after.size(), after) == 0 &&
         isCount(name.substr(before.size(), name.size() - before.size() - after.size()));
}

/// A pattern as a name that one could write.
std::string example(const std::string& pattern) {
  const auto k = pattern.find("<k>");
  return k == std::string::npos ? pattern
                                : pattern.substr(0, k) + "1" + pattern.substr(k + 3);
}

const SchemaRow* find(const std::vector<const SchemaRow*>& rows,
                      const std::string& name) {
  for (const SchemaRow* row : rows)
    if (matches(row->name(), name))
      return row;
  return nullptr;
}

/// What has been found among these rows; \throws InputError if nothing.
const SchemaRow& required(const SchemaRows& table, const SchemaRow* row,
                          const std::vector<const SchemaRow*>& rows,
                          const std::string& path, const std::string& name) {
  if (row != nullptr)
    return *row;
  std::vector<std::string> known;
  known.reserve(rows.size());
  for (const SchemaRow* other : rows)
    known.push_back(example(other->name()));
  throw InputError(join(path, name), ": unknown", placesOf(table, name),
                   suggestion(name, known));
}

/// One level of the list against the rows under one pattern.
class Level {
 public:
  /// \param meant path of another list of the scene's choice with nearly this name
  Level(const SchemaRows& table, const Constant& constant, const ParameterList& given,
        const std::string& pattern, std::string path, std::string meant = "")
      : table_(table),
        constant_(constant),
        given_(given),
        path_(std::move(path)),
        meant_(std::move(meant)),
        rows_(childrenOf(table, pattern)) {}

  void complete(ParameterList& result) const {
    for (const auto& item : given_)
      required(table_, find(rows_, item.first), rows_, path_, item.first);
    for (const SchemaRow* row : rows_) {
      if (!active(*row, result))
        continue;
      bool found = false;
      for (const auto& item : given_)
        if (find(rows_, item.first) == row) {
          found = true;
          take(*row, item.first, item.second, result);
        }
      if (!found)
        fill(*row, result);
    }
    for (const auto& item : given_)
      checkActive(item.first, result);
  }

 private:
  /// The sibling whose value decides which keys exist.
  const SchemaRow* selector() const {
    for (const char* name : {"Type", "Law"})
      for (const SchemaRow* row : rows_)
        if (row->name() == name)
          return row;
    return nullptr;
  }

  bool active(const SchemaRow& row, const ParameterList& result) const {
    return row.only.empty() ||
           std::count(row.only.begin(), row.only.end(),
                      result.get<std::string>(selector()->name())) > 0;
  }

  void checkActive(const std::string& name, const ParameterList& result) const {
    const SchemaRow& row = *find(rows_, name);
    if (active(row, result))
      return;
    std::vector<std::string> known;
    for (const SchemaRow* other : rows_)
      if (active(*other, result))
        known.push_back(example(other->name()));
    const std::string key = selector()->name();
    throw InputError(join(path_, name), ": belongs to ", key, " ", quotedList(row.only),
                     ", but ", key, " is '", result.get<std::string>(key),
                     "'; known here: ", quotedList(known));
  }

  void take(const SchemaRow& row, const std::string& name, const ParameterEntry& entry,
            ParameterList& result) const {
    if (row.kind != Kind::List && row.kind != Kind::Free) {
      result.setEntry(name,
                      Conversion(entry, row, join(path_, name), constant_).checked());
      return;
    }
    if (!entry.isList())
      throw InputError(join(path_, name), ": is ", describe(entry),
                       ", wanted: a sublist (ParameterList)");
    const auto& sublist = getValue<ParameterList>(entry);
    if (row.kind == Kind::Free)
      result.sublist(name).setParameters(sublist);
    else
      Level(table_, constant_, sublist, row.path, join(path_, name),
            isAnyName(row.name()) ? nearlyNamed(name) : "")
          .complete(result.sublist(name));
  }

  std::string nearlyNamed(const std::string& name) const {
    std::vector<std::string> others;
    for (const auto& item : given_)
      if (item.first != name)
        others.push_back(item.first);
    const std::string near = nearest(name, others);
    return near.empty() ? "" : join(path_, near);
  }

  void fill(const SchemaRow& row, ParameterList& result) const {
    if (row.required)
      throw InputError(join(path_, row.name()), ": missing; ", row.meaning,
                       row.range().empty() ? "" : ", " + row.range(),
                       meant_.empty() ? "" : "; did you mean " + meant_ + "?");
    if (row.kind == Kind::List && !isAnyName(row.name()))
      Level(table_, constant_, ParameterList(), row.path, join(path_, row.name()))
          .complete(result.sublist(row.name()));
    else if (!row.defaultValue.empty())
      result.setEntry(row.name(), defaultOf(row));
  }

  const SchemaRows& table_;
  const Constant& constant_;
  const ParameterList& given_;
  std::string path_;
  std::string meant_;
  std::vector<const SchemaRow*> rows_;
};

}  // namespace

const SchemaRow& declared(const SchemaRows& table, const std::string& path) {
  std::string pattern;
  std::string walked;
  const SchemaRow* row = nullptr;
  for (const std::string& name : namesOf(path)) {
    const auto rows = childrenOf(table, pattern);
    row = &required(table, name.empty() ? nullptr : find(rows, name), rows, walked, name);
    pattern = row->path;
    walked = join(walked, name);
  }
  return *row;
}

ParameterList complete(const SchemaRows& table, const ParameterList& given,
                       const std::string& title, const Constant& constant) {
  ParameterList result(title);
  Level(table, constant, given, "", "").complete(result);
  return result;
}

}  // namespace epafi::bem
