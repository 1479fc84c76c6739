#pragma once

#include "bem/base/SchemaRow.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// The keys of a list of these; `degree` is what it has for a Degree that is not given, null:
/// another list says it.
bem::SchemaRows meshRows(const char* degree = nullptr);

/// A body's elements and degree, of its validated list Mesh; what that does not say, the
/// scene's Discretization does.
///
/// \param path  of the body, for messages
/// \throws bem::InputError for numbers that are not one for each edge, Mesh Size beside
///   them, elements that turn by more than 180 degrees, more than a million of them.
void readMesh(const Teuchos::ParameterList& own,
              const Teuchos::ParameterList& discretization, const std::string& path,
              Body& body);

}  // namespace epafi::drivers
