#pragma once

#include "bem/mesh/Mesh.hpp"

namespace epafi::adaptivity {

/// Something at the start and the end of an element.
struct AtEnds {
  bem::Vec2 start;
  bem::Vec2 end;
};

struct EndValues {
  double start;  ///< e(-t)
  double end;    ///< e(t)
};

/// The polynomial of degree p that stands for the value at t = 1 of polynomials v of that
/// degree:
///
///   e(t) = Σ_k (k + 1/2) P_k(t),  k = 0 ... p,   ∫ e v dt = v(1);  e(-t) has v(-1).
EndValues endValues(int degree, double t);

/// (factors.start e(-t) + factors.end e(t)) / half at a point of an element.
bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t);

}  // namespace epafi::adaptivity
