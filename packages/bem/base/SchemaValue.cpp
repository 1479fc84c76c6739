#include "bem/base/SchemaValue.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterEntry.hpp>
#include <Teuchos_RCP.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

using Teuchos::ParameterEntry;

std::string describe(const ParameterEntry& entry) {
  if (entry.isList())
    return "a sublist";
  const std::string type = entry.getAny(false).typeName();
  return entry.isType<std::string>()
             ? "the string '" + Teuchos::getValue<std::string>(entry) + "'"
             : "of type " + type;
}

namespace {

template <class T>
bool holds(const ParameterEntry& entry) {
  return !entry.isList() && entry.isType<T>();
}

template <class T>
const T& value(const ParameterEntry& entry) {
  return Teuchos::getValue<T>(entry);
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

Teuchos::RCP<ParameterEntry> asPoints(const ParameterEntry& entry) {
  if (!holds<Teuchos::TwoDArray<int>>(entry))
    return keptIf<Teuchos::TwoDArray<double>>(entry);
  const auto& whole = value<Teuchos::TwoDArray<int>>(entry);
  Teuchos::TwoDArray<double> table(whole.getNumRows(), whole.getNumCols());
  for (int i = 0; i < whole.getNumRows(); ++i)
    for (int j = 0; j < whole.getNumCols(); ++j)
      table(i, j) = whole(i, j);
  return kept(table);
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

/// Numbers count as their texts.
Teuchos::RCP<ParameterEntry> asNames(const ParameterEntry& entry) {
  Teuchos::Array<std::string> names;
  for (const double number : numbersOf(entry))
    names.push_back(shortest(number));
  return names.empty() ? keptIf<Teuchos::Array<std::string>>(entry) : kept(names);
}

/// The same value in the type that the kind is kept as; null if that is not possible.
Teuchos::RCP<ParameterEntry> converted(const ParameterEntry& entry, Kind kind) {
  using Convert = Teuchos::RCP<ParameterEntry> (*)(const ParameterEntry&);
  static constexpr Convert table[] = {
      // in the order of Kind, whose last two are lists
      asReal,   keptIf<int>, keptIf<bool>, keptIf<std::string>, asExpression, asNames,
      asCounts, asReals,     asPoints};
  return table[static_cast<std::size_t>(kind)](entry);
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
      throw InputError(place, " = ", shortest(number), "; allowed: ", interval.text());
}

void checkOneOf(const std::vector<std::string>& names, const ParameterEntry& entry,
                const std::string& place) {
  for (const std::string& text : stringsOf(entry))
    if (std::find(names.begin(), names.end(), text) == names.end())
      throw InputError(place, " = '", text, "'; did you mean '", nearest(text, names),
                       "'? allowed: ", quotedList(names));
}

void checkRange(const ParameterEntry& entry, const SchemaRow& row,
                const std::string& place) {
  if (!row.allowed.empty())
    checkOneOf(row.allowed, entry, place);
  else
    checkWithin(row.interval, entry, place);
  if (row.kind == Kind::Points &&
      value<Teuchos::TwoDArray<double>>(entry).getNumCols() != 2)
    throw InputError(place, ": a point has 2 coordinates, the table has ",
                     value<Teuchos::TwoDArray<double>>(entry).getNumCols(), " columns");
}

}  // namespace

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
                       const std::string& place) {
  const Teuchos::RCP<ParameterEntry> result = converted(entry, row.kind);
  if (result.is_null())
    throw InputError(place, ": is ", describe(entry),
                     ", wanted: ", textOf(row.kind).wanted);
  checkRange(*result, row, place);
  // a default that used.xml tells apart from what the user wrote remains one
  const Teuchos::any& given = result->getAny(false);
  if (entry.isDefault() && !row.standard.empty() &&
      given == standardOf(row).getAny(false))
    result->setAnyValue(given, true);
  return *result;
}

}  // namespace epafi::bem
