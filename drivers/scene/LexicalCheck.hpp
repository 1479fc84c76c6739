#pragma once

#include <string>

namespace Teuchos {
class XMLObject;
}

namespace epafi::drivers {

/// Does a text spell a value of a Teuchos type, completely and within its range?
///
/// Teuchos converts what it can and drops the rest: 'abc' becomes 0, '3.7' an int 3,
/// '1e999' infinity, '1d-3' 1, a letter in an array 0.  So the text is read here first.
///
/// Types: int, double, bool, string, which are all that keys have; Array(T), {a, b, c};
/// TwoDArray(T), RxC:{row by row}.
/// \throws bem::InputError with what is wrong and what would be right; without file and
/// path.
void checkValue(const std::string& type, const std::string& value);

/// Checks a whole XML list as it was written: tags, names (given, not repeated), types,
/// values.
/// \throws bem::InputError with the path A->B->Key; without the file.
void checkLexically(const Teuchos::XMLObject& root);

}  // namespace epafi::drivers
