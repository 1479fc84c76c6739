#pragma once

#include "bem/base/Written.hpp"

#include <limits>
#include <string>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace epafi::bem {

/// An interval of admissible numbers; an open end is not itself admissible.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lowOpen = false;
  bool highOpen = false;

  bool contains(double value) const;  ///< false for NaN
  std::string text() const;           ///< ">= 0", "> 0", "from 1 to 25", "in (-1, 0.5)"
};

inline Interval from(double low) {
  return {low, std::numeric_limits<double>::infinity(), false, false};
}

inline Interval above(double low) {
  return {low, std::numeric_limits<double>::infinity(), true, false};
}

/// Type of the value of a key.
enum class Kind {
  Real,        ///< double; an int is accepted
  Whole,       ///< int
  Flag,        ///< bool
  Text,        ///< string
  Expression,  ///< string in x, y and t; a number is accepted
  Names,       ///< Array(string)
  Counts,      ///< Array(int); a single int is accepted
  Reals,       ///< Array(double); ints and a single number are accepted
  Points,      ///< TwoDArray(double), n x 2; ints are accepted
  List,        ///< a sublist with declared keys
  Free         ///< a sublist that is passed on unchecked
};

/// Names of a kind.
struct KindText {
  const char* element;  ///< type of one value, see Written
  const char* type;     ///< type in a Teuchos list: "double", "Array(int)", ...
  const char* wanted;   ///< in error messages
  const char* sample;   ///< an example value, for keys without default
};
const KindText& textOf(Kind kind);

/// Separator of the names of a path.
inline constexpr char arrow[] = "->";
/// A->B->Key from A->B and Key; Key alone if the path is empty.
std::string join(const std::string& path, const std::string& name);
/// A, B and Key of A->B->Key.
std::vector<std::string> namesOf(const std::string& path);
/// Key of A->B->Key.
std::string lastOf(const std::string& path);

/// Declaration of a key: type, default and meaning as in valid parameters of Teuchos, and
/// its unit, whether it is required, and for which siblings it exists.
///
/// Names in `path` are literal except <body> and <constant>, which match any name, and <k>,
/// which matches 1, 2, ...
struct SchemaRow {
  std::string path;  ///< A->B->Key, relative to the list of the table
  Kind kind = Kind::Text;
  std::string meaning;
  std::string unit;          ///< empty for names and lists
  std::string defaultValue;  ///< default, as in a scene; empty: none
  bool required = false;
  /// The key exists only if the sibling "Type" or "Law" has one of these values; empty:
  /// always.
  std::vector<std::string> only;
  Interval interval;                 ///< of numbers
  std::vector<std::string> allowed;  ///< of strings; empty: any

  std::string parent() const;
  std::string name() const { return lastOf(path); }
  /// "> 0", "'A' or 'B'"; empty if all values of the type are allowed.
  std::string range() const;
};

/// A row as a table says it: name, type, unit and range of numbers, meaning; the rest by name.
struct Row : SchemaRow {
  Row(const std::string& name, Kind type, const std::string& sense) {
    path = name;
    kind = type;
    meaning = sense;
  }
  Row(const std::string& name, Kind type, const std::string& one,
      const std::string& sense)
      : Row(name, type, sense) {
    unit = one;
  }
  Row(const std::string& name, Kind type, const std::string& one, const Interval& range,
      const std::string& sense)
      : Row(name, type, one, sense) {
    interval = range;
  }
  Row& defaultValue(const std::string& text) {
    return SchemaRow::defaultValue = text, *this;
  }
  Row& defaultValue(double value) { return defaultValue(shortest(value)); }
  Row& required() { return SchemaRow::required = true, *this; }
  Row& only(const std::string& selector) { return SchemaRow::only = {selector}, *this; }
  Row& allowed(const std::vector<std::string>& names) {
    return SchemaRow::allowed = names, *this;
  }
};

using SchemaRows = std::vector<SchemaRow>;

/// Rows of the keys directly in the list `parent`.
std::vector<const SchemaRow*> childrenOf(const SchemaRows& table,
                                         const std::string& parent);

/// "; it belongs to 'A' or 'B'": the lists that have a key of this name; empty if none has.
std::string placesOf(const SchemaRows& table, const std::string& name);

/// Appends rows to a table with paths below `parent`; rows with the same path and different
/// siblings are merged.
/// \throws InputError if rows with the same path differ in more than meaning and siblings
void append(SchemaRows& table, const SchemaRows& rows, const std::string& parent = "");

}  // namespace epafi::bem
