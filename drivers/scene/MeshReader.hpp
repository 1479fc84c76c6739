#pragma once

#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Schema rows of a mesh.  `degree`: default of Degree; null: none, Discretization
/// applies.
bem::SchemaRows meshRows(const char* degree = nullptr);

/// Sets elements and degree of a body from its validated list Mesh; what is missing there
/// is taken from Discretization.
///
/// \param path  path of the body, for messages
/// \throws bem::InputError unless there is one number per edge, for Mesh Size beside
///   them, elements that turn by more than 180 degrees, and more than a million elements.
void readMesh(const Teuchos::ParameterList& own,
              const Teuchos::ParameterList& discretization, const std::string& path,
              Body& body);

}  // namespace epafi::drivers
