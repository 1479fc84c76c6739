#pragma once

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace epafi::drivers {

/// Replaces Geometry->File by the vertices and edges in that file, so that used.xml needs
/// no other file; without File it checks that Vertices and Edges are given.
///
/// \param sceneFile  relative names start from its folder
/// \param path  of the list, for messages
/// \throws bem::InputError if both or neither are given, or the file is no outline.
void expandGeometryFile(Teuchos::ParameterList& geometry, const std::string& sceneFile,
                        const std::string& path);

}  // namespace epafi::drivers
