#pragma once

#include "bem/geometry/Outline.hpp"

#include <string>

namespace epafi::drivers {

/// The outline in a drawing (.dxf, ASCII, any version).
///
/// Read are LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE of model space; the layer's name is
/// the boundary's name.  Ends closer than 1e-6 of the drawing's size are one corner.  They
/// chain into closed loops as chained() says.  Texts, dimensions, points and hatches are
/// skipped; coordinates are taken as they are, whatever unit the drawing claims.
/// \throws bem::InputError naming the line of the file, for what is no drawing or no
///   outline, a number that is none, and curves of another kind (splines, ellipses, blocks).
bem::Loops readDxf(const std::string& text);

}  // namespace epafi::drivers
