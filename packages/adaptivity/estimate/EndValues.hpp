#pragma once

#include "bem/basis/EndValues.hpp"
#include "bem/mesh/Mesh.hpp"

namespace epafi::adaptivity {

/// Vectors at the start and the end of an element.
struct AtEnds {
  bem::Vec2 start;
  bem::Vec2 end;
};

/// (factors.start e(-t) + factors.end e(t)) / half at a point of an element, see
/// bem::endValues.
bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t);

}  // namespace epafi::adaptivity
