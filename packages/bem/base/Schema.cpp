#include "bem/base/Schema.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

const std::string arrow = "->";

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + arrow + name;
}

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

std::string describe(const ParameterEntry& entry) {
  if (entry.isList())
    return "a sublist";
  const std::string type = entry.getAny(false).typeName();
  return entry.isType<std::string>()
             ? "the string '" + Teuchos::getValue<std::string>(entry) + "'"
             : "of type " + type;
}

std::string wanted(Kind kind) {
  switch (kind) {
    case Kind::Real:
      return "a number (double)";
    case Kind::Whole:
      return "a whole number (int)";
    case Kind::Flag:
      return "true or false (bool)";
    case Kind::Expression:
      return "an expression (string)";
    case Kind::Reals:
      return "a list of numbers (Array(double))";
    case Kind::Points:
      return "a table n x 2 of numbers (TwoDArray(double))";
    default:
      return typeName(kind);
  }
}

template <class T>
bool holds(const ParameterEntry& entry) {
  return !entry.isList() && entry.isType<T>();
}

template <class T>
const T& value(const ParameterEntry& entry) {
  return Teuchos::getValue<T>(entry);
}

ParameterEntry points(const ParameterEntry& entry) {
  if (holds<Teuchos::TwoDArray<double>>(entry))
    return entry;
  const auto& whole = value<Teuchos::TwoDArray<int>>(entry);
  Teuchos::TwoDArray<double> table(whole.getNumRows(), whole.getNumCols());
  for (int i = 0; i < whole.getNumRows(); ++i)
    for (int j = 0; j < whole.getNumCols(); ++j)
      table(i, j) = whole(i, j);
  return ParameterEntry(table);
}

template <class T>
Teuchos::RCP<ParameterEntry> kept(const T& v) {
  return Teuchos::rcp(new ParameterEntry(v));
}

template <class T>
Teuchos::RCP<ParameterEntry> keptIf(const ParameterEntry& entry) {
  return holds<T>(entry) ? kept(value<T>(entry)) : Teuchos::null;
}

Teuchos::RCP<ParameterEntry> asReal(const ParameterEntry& entry) {
  if (holds<int>(entry))
    return kept(static_cast<double>(value<int>(entry)));
  if (holds<long long>(entry))
    return kept(static_cast<double>(value<long long>(entry)));
  return keptIf<double>(entry);
}

Teuchos::RCP<ParameterEntry> asExpression(const ParameterEntry& entry) {
  if (holds<int>(entry))
    return kept(std::to_string(value<int>(entry)));
  if (holds<long long>(entry))
    return kept(std::to_string(value<long long>(entry)));
  if (holds<double>(entry))
    return kept(shortest(value<double>(entry)));
  return keptIf<std::string>(entry);
}

Teuchos::RCP<ParameterEntry> asCounts(const ParameterEntry& entry) {
  if (holds<int>(entry))
    return kept(Teuchos::Array<int>(1, value<int>(entry)));
  return keptIf<Teuchos::Array<int>>(entry);
}

Teuchos::RCP<ParameterEntry> asReals(const ParameterEntry& entry) {
  if (holds<Teuchos::Array<int>>(entry)) {
    const auto& whole = value<Teuchos::Array<int>>(entry);
    return kept(Teuchos::Array<double>(whole.begin(), whole.end()));
  }
  const Teuchos::RCP<ParameterEntry> one = asReal(entry);
  if (!one.is_null())
    return kept(Teuchos::Array<double>(1, value<double>(*one)));
  return keptIf<Teuchos::Array<double>>(entry);
}

/// The same value in the type that the kind is kept as; null if that is not possible.
Teuchos::RCP<ParameterEntry> converted(const ParameterEntry& entry, Kind kind) {
  switch (kind) {
    case Kind::Real:
      return asReal(entry);
    case Kind::Whole:
      return keptIf<int>(entry);
    case Kind::Flag:
      return keptIf<bool>(entry);
    case Kind::Expression:
      return asExpression(entry);
    case Kind::Text:
      return keptIf<std::string>(entry);
    case Kind::Names:
      return keptIf<Teuchos::Array<std::string>>(entry);
    case Kind::Counts:
      return asCounts(entry);
    case Kind::Reals:
      return asReals(entry);
    case Kind::Points:
      return holds<Teuchos::TwoDArray<double>>(entry) ||
                     holds<Teuchos::TwoDArray<int>>(entry)
                 ? Teuchos::rcp(new ParameterEntry(points(entry)))
                 : Teuchos::null;
    case Kind::List:
    case Kind::Free:
      break;
  }
  return Teuchos::null;
}

/// The numbers of an entry: one, or those of an array; empty if it holds none.
std::vector<double> numbersOf(const ParameterEntry& entry) {
  if (entry.isType<double>())
    return {Teuchos::getValue<double>(entry)};
  if (entry.isType<int>())
    return {static_cast<double>(Teuchos::getValue<int>(entry))};
  if (entry.isType<Teuchos::Array<int>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<int>>(entry);
    return {array.begin(), array.end()};
  }
  if (entry.isType<Teuchos::Array<double>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<double>>(entry);
    return {array.begin(), array.end()};
  }
  return {};
}

std::vector<std::string> stringsOf(const ParameterEntry& entry) {
  if (entry.isType<std::string>())
    return {Teuchos::getValue<std::string>(entry)};
  if (entry.isType<Teuchos::Array<std::string>>()) {
    const auto& array = Teuchos::getValue<Teuchos::Array<std::string>>(entry);
    return {array.begin(), array.end()};
  }
  return {};
}

void checkWithin(const Interval& interval, const ParameterEntry& entry,
                 const std::string& place) {
  for (const double number : numbersOf(entry))
    if (!interval.contains(number) || !std::isfinite(number))
      throw InputError(
          message(place, " = ", shortest(number), "; allowed: ", interval.text()));
}

void checkOneOf(const std::vector<std::string>& names, const ParameterEntry& entry,
                const std::string& place) {
  for (const std::string& text : stringsOf(entry))
    if (std::find(names.begin(), names.end(), text) == names.end())
      throw InputError(message(place, " = '", text, "'; did you mean '",
                               nearest(text, names), "'? allowed: ", quotedList(names)));
}

void checkRange(const ParameterEntry& entry, const SchemaRow& row,
                const std::string& name, const std::string& path) {
  if (!row.allowed.empty())
    checkOneOf(row.allowed, entry, join(path, name));
  else
    checkWithin(row.interval, entry, join(path, name));
  if (row.kind == Kind::Points &&
      value<Teuchos::TwoDArray<double>>(entry).getNumCols() != 2)
    throw InputError(
        message(join(path, name), ": a point has 2 coordinates, the table has ",
                value<Teuchos::TwoDArray<double>>(entry).getNumCols(), " columns"));
}

/// A row's default, marked as one; the row must have one.
ParameterEntry standardOf(const SchemaRow& row) {
  switch (row.kind) {
    case Kind::Real:
      return ParameterEntry(std::stod(row.standard), true);
    case Kind::Whole:
      return ParameterEntry(std::stoi(row.standard), true);
    case Kind::Flag:
      return ParameterEntry(row.standard == "true", true);
    default:
      return ParameterEntry(row.standard, true);
  }
}

ParameterEntry checked(const ParameterEntry& entry, const SchemaRow& row,
                       const std::string& name, const std::string& path) {
  const Teuchos::RCP<ParameterEntry> result = converted(entry, row.kind);
  if (result.is_null())
    throw InputError(message(join(path, name), ": is ", describe(entry),
                             ", wanted: ", wanted(row.kind)));
  checkRange(*result, row, name, path);
  // a default that used.xml tells apart from what the user wrote remains one
  const Teuchos::any& given = result->getAny(false);
  if (entry.isDefault() && !row.standard.empty() &&
      given == standardOf(row).getAny(false))
    result->setAnyValue(given, true);
  return *result;
}

/// One level of the list against the rows under one pattern.
class Level {
 public:
  Level(const SchemaRows& table, const ParameterList& given, const std::string& pattern,
        std::string path)
      : table_(table),
        given_(given),
        path_(std::move(path)),
        rows_(childrenOf(table, pattern)) {}

  void complete(ParameterList& result) const {
    for (const auto& item : given_)
      checkKnown(item.first);
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
  void checkKnown(const std::string& name) const {
    if (find(rows_, name) != nullptr)
      return;
    std::vector<std::string> known;
    for (const SchemaRow* row : rows_)
      known.push_back(example(row->name()));
    throw InputError(message(join(path_, name), ": unknown", suggestion(name, known)));
  }

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
    throw InputError(message(
        join(path_, name), ": belongs to ", key, " ", quotedList(row.only), ", but ", key,
        " is '", result.get<std::string>(key), "'; known here: ", quotedList(known)));
  }

  void take(const SchemaRow& row, const std::string& name, const ParameterEntry& entry,
            ParameterList& result) const {
    if (row.kind != Kind::List && row.kind != Kind::Free) {
      result.setEntry(name, checked(entry, row, name, path_));
      return;
    }
    if (!entry.isList())
      throw InputError(message(join(path_, name), ": is ", describe(entry),
                               ", wanted: a sublist (ParameterList)"));
    const auto& sublist = value<ParameterList>(entry);
    if (row.kind == Kind::Free)
      result.sublist(name).setParameters(sublist);
    else
      Level(table_, sublist, row.path, join(path_, name)).complete(result.sublist(name));
  }

  void fill(const SchemaRow& row, ParameterList& result) const {
    if (row.required)
      throw InputError(message(join(path_, row.name()), ": missing; ", row.meaning,
                               row.range().empty() ? "" : ", " + row.range()));
    if (row.kind == Kind::List && !isAnyName(row.name()))
      Level(table_, ParameterList(), row.path, join(path_, row.name()))
          .complete(result.sublist(row.name()));
    else if (!row.standard.empty())
      result.setEntry(row.name(), standardOf(row));
  }

  const SchemaRows& table_;
  const ParameterList& given_;
  std::string path_;
  std::vector<const SchemaRow*> rows_;
};

}  // namespace

const SchemaRow& declared(const SchemaRows& table, const std::string& path) {
  std::string pattern;
  std::string walked;
  const SchemaRow* row = nullptr;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find(arrow, at), path.size());
    const std::string name = path.substr(at, end - at);
    const auto rows = childrenOf(table, pattern);
    row = name.empty() ? nullptr : find(rows, name);
    if (row == nullptr) {
      std::vector<std::string> known;
      known.reserve(rows.size());
      for (const SchemaRow* other : rows)
        known.push_back(example(other->name()));
      throw InputError(message(join(walked, name), ": unknown", suggestion(name, known)));
    }
    pattern = row->path;
    walked = join(walked, name);
    at = end + arrow.size();
  }
  return *row;
}

ParameterList complete(const SchemaRows& table, const ParameterList& given,
                       const std::string& title) {
  ParameterList result(title);
  Level(table, given, "", "").complete(result);
  return result;
}

}  // namespace epafi::bem
