#include "bem/base/SchemaValue.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Suggestion.hpp"
#include "bem/base/Written.hpp"

#include <Teuchos_ParameterEntry.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace epafi::bem {

using Shape = Written::Shape;
using Teuchos::ParameterEntry;

std::string describe(const ParameterEntry& entry) {
  if (entry.isList())
    return "a sublist";
  const auto written = writtenIn(entry);
  if (!written)
    return "of type " + entry.getAny(false).typeName();
  return written->fullType() == "string" ? "the string '" + written->texts.front() + "'"
                                         : "of type " + written->fullType();
}

ParameterEntry defaultOf(const SchemaRow& row) {
  assert(!row.defaultValue.empty());
  ParameterEntry entry =
      entryOf({textOf(row.kind).element, Shape::One, {row.defaultValue}});
  entry.setAnyValue(Teuchos::any(entry.getAny(false)), true);
  return entry;
}

namespace {

/// Makes of what a list holds at a place the value that a row declares.
class Conversion {
 public:
  Conversion(const ParameterEntry& entry, const SchemaRow& row, const std::string& place,
             const Constant& constant)
      : entry_(entry),
        written_(writtenIn(entry).value_or(Written{})),
        row_(row),
        place_(place),
        constant_(constant) {}

  ParameterEntry checked() const {
    const Written value = converted();
    ParameterEntry result = within(place_ + ": ", [&] { return entryOf(value); });
    check(value);
    // a default that used.xml tells apart from what the user wrote remains one
    const Teuchos::any any = result.getAny(false);
    if (entry_.isDefault() && !row_.defaultValue.empty() &&
        any == defaultOf(row_).getAny(false))
      result.setAnyValue(any, true);
    return result;
  }

 private:
  bool isWhole() const { return row_.kind == Kind::Whole || row_.kind == Kind::Counts; }

  /// Do shape and type fit, or are texts constant expressions?  Numbers are texts, too, and whole
  /// ones numbers.
  bool fits() const {
    const bool one = written_.shape == Shape::One;
    const bool row = one || written_.shape == Shape::Array;
    const bool isNumber = (isWhole() ? written_.type == "int" : written_.isNumber()) ||
                          (written_.isText() && constant_);
    switch (row_.kind) {
      case Kind::Real:
      case Kind::Whole:
        return one && isNumber;
      case Kind::Reals:
      case Kind::Counts:
        return row && isNumber;
      case Kind::Points:
        return !row && isNumber;
      case Kind::Text:
        return one && written_.isText();
      case Kind::Expression:
        return one && (written_.isText() || written_.isNumber());
      case Kind::Names:
        return row &&
               (written_.isText() ? !one
                                  : written_.isNumber() && !written_.texts.empty());
      default:  // a flag: lists do not come here
        return written_.type == "bool";
    }
  }

  Written converted() const {
    if (!fits())
      throw refusal();
    Written value = written_;
    value.type = textOf(row_.kind).element;
    if (row_.kind == Kind::Names || row_.kind == Kind::Reals || row_.kind == Kind::Counts)
      value.shape = Shape::Array;
    if (value.isNumber() && written_.isText())
      for (std::string& text : value.texts)
        text = evaluated(text);
    return value;
  }

  InputError refusal() const {
    constexpr int largest = std::numeric_limits<int>::max();
    const bool tooLarge =
        isWhole() && written_.type == "double" &&
        std::any_of(written_.texts.begin(), written_.texts.end(),
                    [](const std::string& text) { return realIn(text) > largest; });
    return InputError(place_, ": is ", describe(entry_), tooLarge ? " and too large" : "",
                      ", wanted: ", textOf(row_.kind).wanted,
                      tooLarge ? message(" up to ", largest) : "");
  }

  /// The value of a constant expression; no fractions for whole numbers.
  std::string evaluated(const std::string& text) const {
    try {
      const double value = constant_(text, place_);
      constexpr double largest = std::numeric_limits<int>::max();
      if (isWhole() && (value != std::round(value) || std::abs(value) > largest))
        throw InputError(place_, " = '", text, "' is ", shortest(value));
      return isWhole() ? std::to_string(static_cast<int>(value)) : shortest(value);
    } catch (const InputError& error) {
      throw InputError(error.what(), "; wanted: ", textOf(row_.kind).wanted,
                       ", or an expression in Constants for each number");
    }
  }

  void check(const Written& value) const {
    const auto& names = row_.allowed;
    for (const std::string& text : value.texts) {
      if (value.isNumber() && !row_.interval.contains(realIn(text)))
        throw InputError(place_, " = ", text, "; allowed: ", row_.interval.text(), "; ",
                         row_.meaning);
      if (!names.empty() && std::find(names.begin(), names.end(), text) == names.end())
        throw InputError(place_, " = '", text, "'", meant(text, names),
                         "; allowed: ", quotedList(names));
    }
    if (row_.kind == Kind::Points && value.columns != 2)
      throw InputError(place_, ": a point has 2 coordinates, the table has ",
                       value.columns, " columns");
  }

  const ParameterEntry& entry_;
  const Written written_;
  const SchemaRow& row_;
  const std::string& place_;
  const Constant& constant_;
};

}  // namespace

ParameterEntry valueOf(const ParameterEntry& entry, const SchemaRow& row,
                       const std::string& place, const Constant& constant) {
  return Conversion(entry, row, place, constant).checked();
}

}  // namespace epafi::bem
