#pragma once

#include "bem/base/SchemaRow.hpp"

namespace epafi::bem {

/// The row that a concrete path A->B->Key belongs to.
/// \throws InputError for an unknown path, naming the nearest known key.
const SchemaRow& declared(const SchemaRows& table, const std::string& path);

/// The list in the order of the table: checked, numbers turned into the declared type,
/// every default filled in.
/// \throws InputError with the path for an unknown or missing key, a wrong type, a value
/// out of range.
Teuchos::ParameterList complete(const SchemaRows& table,
                                const Teuchos::ParameterList& given,
                                const std::string& title);

}  // namespace epafi::bem
