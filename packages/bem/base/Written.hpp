#pragma once

#include <optional>
#include <string>
#include <vector>

namespace Teuchos {
class ParameterEntry;
}

namespace epafi::bem {

/// A value of a list as it is written: one text, those of an array or, row by row, of a table.
struct Written {
  enum class Shape { One, Array, Table };

  std::string type;  ///< of each: "int", "double", "bool" or "string"
  Shape shape = Shape::One;
  std::vector<std::string> texts;
  int rows = 1;
  int columns = 1;

  bool isText() const { return type == "string"; }
  bool isNumber() const { return type == "int" || type == "double"; }
  /// "double", "Array(double)", "TwoDArray(double)"
  std::string fullType() const;
};

/// The shortest text that reads back to the same number.
std::string shortest(double value);

/// The number that a whole text spells.
///
/// The reader of Teuchos ignores what it cannot convert: 'abc' becomes 0, '3.7' an int 3,
/// '1e999' infinity, '1d-3' 1, a letter in an array 0.
/// \throws InputError with the error and the valid form
double realIn(const std::string& text);
int wholeIn(const std::string& text);

/// The value in a list of Teuchos.
/// \throws InputError for texts that do not fit the type, and for arrays of bool
Teuchos::ParameterEntry entryOf(const Written& written);

/// The contrary; nothing of lists.
std::optional<Written> writtenIn(const Teuchos::ParameterEntry& entry);

}  // namespace epafi::bem
