#pragma once

#include "bem/base/SchemaRow.hpp"

namespace Teuchos {
class ParameterEntry;
}

namespace epafi::bem {

/// "a sublist", "the string 'x'", "of type int"
std::string describe(const Teuchos::ParameterEntry& entry);

/// A row's default, marked as one; the row must have one.
Teuchos::ParameterEntry standardOf(const SchemaRow& row);

/// An entry in the type that its row declares.
/// \throws InputError, beginning with its place, for a wrong type or a value out of range.
Teuchos::ParameterEntry checked(const Teuchos::ParameterEntry& entry,
                                const SchemaRow& row, const std::string& place);

}  // namespace epafi::bem
