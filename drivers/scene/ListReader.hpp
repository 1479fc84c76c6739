#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Teuchos {
class XMLObject;
}

namespace epafi::drivers {

/// The value of a Teuchos type that a text spells, completely and within its range.
///
/// Teuchos' own reader converts what it can and drops the rest: 'abc' becomes 0, '3.7' an int 3,
/// '1e999' infinity, '1d-3' 1, a letter in an array 0.
///
/// Types: int, double, bool, string, which are all that keys have; Array(T), {a, b, c};
/// TwoDArray(T), RxC:{row by row}; T is no bool.
/// \throws bem::InputError with what is wrong and what would be right; without file and
/// path.
Teuchos::ParameterEntry readValue(const std::string& type, const std::string& value);

/// A whole XML list as it was written: tags, names (given, not repeated), types, values.
/// \throws bem::InputError with the path A->B->Key; without the file.
Teuchos::ParameterList readList(const Teuchos::XMLObject& root);

}  // namespace epafi::drivers
