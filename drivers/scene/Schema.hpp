#pragma once

#include "bem/base/Parameters.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace epafi::drivers {

using Parameter = bem::SchemaRow;
using bem::Kind;
using bem::typeName;

/// All parameters of a scene.  This table alone feeds validation, defaults, --set, `epafi
/// parameters` and the tests; a new parameter is one line here and its use in
/// SceneReader.
const std::vector<Parameter>& parameters();

/// The row that a concrete path A->B->Key belongs to.
/// \throws bem::InputError for an unknown path, naming the nearest known key.
const Parameter& declared(const std::string& path);

/// The list in the order of the table: checked, numbers turned into the declared type,
/// every default filled in.
/// \throws bem::InputError with the path for an unknown or missing key, a wrong type, a
///   value out of range.
Teuchos::ParameterList complete(const std::vector<Parameter>& table,
                                const Teuchos::ParameterList& given,
                                const std::string& title);
/// The same by the table of scenes.
Teuchos::ParameterList complete(const Teuchos::ParameterList& given,
                                const std::string& title);

}  // namespace epafi::drivers
