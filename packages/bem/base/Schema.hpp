#pragma once

#include "bem/base/SchemaRow.hpp"

namespace epafi::bem {

/// The row of a concrete path A->B->Key.
/// \throws InputError for an unknown path, naming the nearest known key
const SchemaRow& declared(const SchemaRows& table, const std::string& path);

/// Checks a list and returns it in the order of the table, numbers converted to the declared
/// type, with all defaults.
/// \throws InputError with the path for an unknown or missing key, a wrong type or a value
/// out of range
Teuchos::ParameterList complete(const SchemaRows& table,
                                const Teuchos::ParameterList& given,
                                const std::string& title);

}  // namespace epafi::bem
