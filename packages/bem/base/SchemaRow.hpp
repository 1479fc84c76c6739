#pragma once

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

/// What may stand under a key of a list.
enum class Kind {
  Real,        ///< double; an int is fine
  Whole,       ///< int
  Flag,        ///< bool
  Text,        ///< string
  Expression,  ///< string in x, y and t; a number is fine
  Names,       ///< Array(string)
  Counts,      ///< Array(int); an int alone is one of them
  Reals,       ///< Array(double); ints and a number alone are fine
  Points,      ///< TwoDArray(double), n x 2; ints are fine
  List,        ///< a sublist with keys of its own
  Free         ///< a sublist that is handed on unread
};

/// What a kind is called.
struct KindText {
  const char* type;    ///< of Teuchos that it is kept as: "double", "Array(int)", ...
  const char* wanted;  ///< in messages
  const char* sample;  ///< a value, for keys that have no default
};
const KindText& textOf(Kind kind);

/// Between the names of a path.
inline constexpr char arrow[] = "->";
/// A->B->Key from A->B and Key; Key alone if the path is empty.
std::string join(const std::string& path, const std::string& name);
/// Key of A->B->Key.
std::string lastOf(const std::string& path);

/// One key of a part's list: what Teuchos' valid parameters say and what they cannot, the
/// unit, whether it is required, under which siblings it exists.
///
/// The names in `path` are literal except for <body>, <constant>, which stand for any
/// name, and <k>, which stands for 1, 2, ...
struct SchemaRow {
  std::string path;  ///< A->B->Key, from the list that the table is for
  Kind kind = Kind::Text;
  std::string meaning;
  std::string unit;      ///< empty for names and lists
  std::string standard;  ///< the default as one would write it; empty if there is none
  bool required = false;
  /// The key exists only where the sibling "Type" or "Law" has one of these values; empty:
  /// everywhere.
  std::vector<std::string> only;
  Interval interval;                 ///< of numbers
  std::vector<std::string> allowed;  ///< of strings; empty: any

  std::string parent() const;
  std::string name() const { return lastOf(path); }
  /// "> 0", "'A' or 'B'"; empty if everything of the type is allowed.
  std::string range() const;
};

/// The shortest text that reads back to the same number.
std::string shortest(double value);

/// A row under construction: the constructor says what every key has, the rest is named.
class Row {
 public:
  Row(const std::string& path, Kind kind, const std::string& meaning) {
    row_.path = path;
    row_.kind = kind;
    row_.meaning = meaning;
  }
  Row& unit(const std::string& unit) { return row_.unit = unit, *this; }
  Row& standard(const std::string& text) { return row_.standard = text, *this; }
  Row& standard(double value) { return standard(shortest(value)); }
  Row& required() { return row_.required = true, *this; }
  Row& only(const std::string& selector) { return row_.only = {selector}, *this; }
  Row& range(const Interval& interval) { return row_.interval = interval, *this; }
  Row& allowed(const std::vector<std::string>& names) {
    return row_.allowed = names, *this;
  }

  // NOLINTNEXTLINE(google-explicit-constructor): tables are written as lists of Rows
  operator SchemaRow() const { return row_; }

 private:
  SchemaRow row_;
};

using SchemaRows = std::vector<SchemaRow>;

/// The rows of a list's own keys.
std::vector<const SchemaRow*> childrenOf(const SchemaRows& table,
                                         const std::string& parent);

/// Appends rows to a table, their paths below `parent`; rows of one path that exist under
/// different siblings become one.
/// \throws InputError if a path has two rows that differ in more than meaning and siblings.
void append(SchemaRows& table, const SchemaRows& rows, const std::string& parent = "");

}  // namespace epafi::bem
