#pragma once

#include "bem/geometry/Outline.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads a validated list Geometry, in which the content of File replaces the key File.
///
/// \param file  the scene file; relative names of geometry files start from its folder
/// \param path  path of the list, for messages
/// \throws bem::InputError if the numbers of edges, bulges and vertices differ, or if
///   holes are not numbered 1, 2, ...
bem::Loops readLoops(Teuchos::ParameterList& geometry, const std::string& file,
                     const std::string& path);

/// \param length  diameter of the largest body, by which all bodies are scaled
/// \throws bem::InputError for closed lines that cross or have the wrong orientation.
std::shared_ptr<const bem::Outline> makeOutline(const bem::Loops& loops, double length,
                                                const std::string& path);

/// The key of a hole 1, 2, ...: "Hole 1 Vertices".
std::string holeKey(int hole, const std::string& what);

/// The rows of a table of coordinates as points.
std::vector<bem::Vec2> pointsOf(const Teuchos::ParameterList& list,
                                const std::string& key);

}  // namespace epafi::drivers
