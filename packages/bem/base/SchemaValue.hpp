#pragma once

#include "bem/base/Schema.hpp"

namespace Teuchos {
class ParameterEntry;
}

namespace epafi::bem {

/// What an entry is, for messages: "a sublist", "the string 'a'", "of type double".
std::string describe(const Teuchos::ParameterEntry& entry);

/// The default of a row, marked as default.  \pre the row has one
Teuchos::ParameterEntry defaultOf(const SchemaRow& row);

/// Of what a list holds at a place the value that a row declares.
/// \throws InputError, beginning with the place, for a wrong type or a value out of range
Teuchos::ParameterEntry valueOf(const Teuchos::ParameterEntry& entry,
                                const SchemaRow& row, const std::string& place,
                                const Constant& constant);

}  // namespace epafi::bem
