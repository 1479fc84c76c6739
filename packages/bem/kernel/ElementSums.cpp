#include "bem/kernel/ElementSums.hpp"

namespace epafi::bem {

// ∫ P_j ds/conj(w) = τ C_j,  ∫ P_j w/conj(w)² ds = τ³ (C_j - 2ib D_j)
SourceSums elementSums(const Curve& segment, const RelativeTarget& target,
                       const LegendreMoments& moments, int j) {
  const Complex tangent = asComplex(segment.segment().tangent);
  const Complex c = moments.c[j];
  const Complex turned = tangent * c;
  // on the element's own line b = 0, and d need not exist
  const Complex cubic =
      target.b() == 0 ? c : c - Complex(0, 2 * target.b()) * moments.d[j];
  return {std::conj(turned), turned, tangent * tangent * tangent * cubic};
}

}  // namespace epafi::bem
