#pragma once

#include "bem/geometry/Outline.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Of a validated list Geometry; what its File names takes the place of File in it.
///
/// \param file  the scene's, where relative names of geometry files start
/// \param path  of the list, for messages
/// \throws bem::InputError for edges, bulges and vertices that do not go together, holes
///   that are not numbered 1, 2, ...
bem::Loops readLoops(Teuchos::ParameterList& geometry, const std::string& file,
                     const std::string& path);

/// \param length  of the largest body; bodies that share a scaling have its
/// \throws bem::InputError for lines that cross or turn the wrong way.
std::shared_ptr<const bem::Outline> makeOutline(const bem::Loops& loops, double length,
                                                const std::string& path);

/// What the parameters of hole 1, 2, ... are called: "Hole 1 Vertices".
std::string holeKey(int hole, const std::string& what);

/// The rows of a table of coordinates.
std::vector<bem::Vec2> pointsOf(const Teuchos::ParameterList& list,
                                const std::string& key);

}  // namespace epafi::drivers
