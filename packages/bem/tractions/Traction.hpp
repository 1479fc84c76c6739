#pragma once

#include "bem/base/Material.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// A vector of the plane as a complex number, x + iy.
inline Complex asComplex(Vec2 v) { return {v.x, v.y}; }

/// The kernels' building blocks integrated over one element against P_j, w = x - y:
///
///   overW = ∫ P_j ds/w,  overConj = ∫ P_j ds/conj(w),  cubic = ∫ P_j w/conj(w)² ds
struct ElementIntegrals {
  Complex overW;
  Complex overConj;
  Complex cubic;
};

/// From the moments (c and d) of the element with tangent `tangent` at a target.
ElementIntegrals elementIntegrals(Complex tangent, const RelativeTarget& target,
                                  const LegendreMoments& moments, int j);

/// Tractions at x on a plane with unit normal N (complex), of a source with one Legendre
/// component on one element.                                        [design.md 4.3, last
/// item]
class TractionKernel {
 public:
  TractionKernel(const Lame& lame, Complex normal) : lame_(lame), normal_(normal) {}

  /// K' f for the density f P_j, f a complex constant.
  Complex adjointDoubleLayer(const ElementIntegrals& in, Complex f) const;

  /// W v for a displacement whose derivative by arc length is v' P_j.
  Complex hypersingular(const ElementIntegrals& in, Complex slope) const;

 private:
  Lame lame_;
  Complex normal_;
};

}  // namespace epafi::bem
