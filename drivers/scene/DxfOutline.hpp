#pragma once

#include "bem/geometry/Outline.hpp"

#include <string>

namespace epafi::drivers {

/// Reads an outline from a drawing (.dxf, ASCII, any version).
///
/// Uses LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE of model space; the name of the layer
/// is the name of the boundary.  Ends closer than 1e-6 of the size of the drawing are one
/// corner.  The pieces form closed loops, see chained().  Texts, dimensions, points and
/// hatches are skipped; the unit of the drawing is ignored.
/// \throws bem::InputError with the line of the file for an invalid drawing, outline or
///   number, and for other curves (splines, ellipses, blocks).
bem::Loops readDxf(const std::string& text);

}  // namespace epafi::drivers
