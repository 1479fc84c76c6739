#pragma once

#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Schema rows of a mesh.  \param degree default of Degree; null: none, that of
/// Discretization
bem::SchemaRows meshRows(const char* degree = nullptr);

/// Sets elements and degree of a body from its validated list Mesh, else from
/// Discretization.
///
/// \param path  of the body, for messages
/// \throws bem::InputError for numbers that are not one for each edge, Mesh Size beside
///   them, elements that turn by more than 180 degrees, more than a million of them.
void readMesh(const Teuchos::ParameterList& own,
              const Teuchos::ParameterList& discretization, const std::string& path,
              Body& body);

}  // namespace epafi::drivers
