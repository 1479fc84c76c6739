#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Teuchos {
class XMLObject;
}

namespace epafi::drivers {

/// A value as it is written: one text, those of an array or, row by row, of a table.
struct Written {
  enum class Shape { One, Array, Table } shape = Shape::One;
  std::vector<std::string> texts;
  int rows = 1;
  int columns = 1;
};
/// As values of the type int, double, string or, of one text, bool.  \throws as readValue.
Teuchos::ParameterEntry toEntry(const std::string& type, const Written& written);

/// Converts a text to a value of a Teuchos type.  The whole text must be valid and in
/// range.
///
/// The reader of Teuchos ignores what it cannot convert: 'abc' becomes 0, '3.7' an int 3,
/// '1e999' infinity, '1d-3' 1, a letter in an array 0.
///
/// Types: int, double, bool, string; Array(T) as {a, b, c}; TwoDArray(T) as RxC:{row by
/// row}, T not bool.
/// \throws bem::InputError with the error and the valid form, without file and path.
Teuchos::ParameterEntry readValue(const std::string& type, const std::string& value);

/// Reads an XML list and checks tags, names (given, unique), types and values.
/// \throws bem::InputError with the path A->B->Key; without the file.
Teuchos::ParameterList readList(const Teuchos::XMLObject& root);

}  // namespace epafi::drivers
