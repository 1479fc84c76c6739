#pragma once

#include "bem/base/SchemaRow.hpp"

namespace Teuchos {
class ParameterEntry;
}

namespace epafi::bem {

/// Description for messages: "a sublist", "the string 'x'", "of type int".
std::string describe(const Teuchos::ParameterEntry& entry);

/// The default of a row, marked as default.  \pre the row has one
Teuchos::ParameterEntry standardOf(const SchemaRow& row);

/// An entry, converted to the declared type of its row.
/// \throws InputError, beginning with `place`, for a wrong type or a value out of range
Teuchos::ParameterEntry checked(const Teuchos::ParameterEntry& entry,
                                const SchemaRow& row, const std::string& place);

}  // namespace epafi::bem
