#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/conditions/Conditions.hpp"

namespace epafi::adaptivity {

/// The mesh with elements on lines of symmetry halved until none is more than twice as long as
/// a neighbour.
///
/// A line goes on where a side ends: beside small elements of the side the body's image has
/// fields that vary as fast, which elements on the line have to follow.  In the whole body
/// there are none.
bem::Mesh gradedLines(bem::Mesh mesh, const contact::Conditions& conditions);

}  // namespace epafi::adaptivity
