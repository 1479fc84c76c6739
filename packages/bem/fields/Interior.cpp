#include "bem/fields/Interior.hpp"

#include "bem/kernel/ElementSums.hpp"
#include "bem/space/LocalField.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// V of f P_j in closed form.
Complex singleLayerOf(const Lame& lame, const Element& element,
                      const RelativeTarget& target, const LegendreMoments& m, int j,
                      Complex f) {
  const Complex tangent = asComplex(element.segment().tangent);
  const double whole = j == 0 ? 2 : 0;
  const Complex phase = tangent * tangent * (whole - Complex(0, 2 * target.b()) * m.c[j]);
  return element.half * singleLayer(lame, (m.l[j] + whole * std::log(element.half)) * f,
                                    whole * f, std::conj(f) * phase);
}

}  // namespace

InteriorValue evaluateInterior(const Space& space, const Lame& lame, const Vector& u,
                               const Vector& psi, Vec2 x) {
  Complex displacement = 0;
  FieldSums sums;
  LegendreMoments moments;
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const RelativeTarget target = element.curve.seen(x);
    const int terms = std::max(element.degree, element.densities);
    evaluateMoments(target, terms, Need::All, moments);
    const LocalField field = localField(space, u, psi, e);
    const Complex normal = asComplex(element.segment().normal);
    for (int j = 0; j <= terms; ++j) {
      const SourceSums in = elementSums(element.curve, target, moments, j);
      const Complex v = field.value[j];
      displacement -=
          doubleLayer(lame, normal * v * in, std::real(std::conj(normal) * v) * in);
      displacement += singleLayerOf(lame, element, target, moments, j, field.density[j]);
      sums.add({field.density[j] * in, field.slope[j] * in});
    }
  }
  const Complex onX = traction(lame, Complex(1, 0), sums);
  const Complex onY = traction(lame, Complex(0, 1), sums);
  return {asVector(displacement), onX.real(), onY.imag(),
          0.5 * (onX.imag() + onY.real())};
}

}  // namespace epafi::bem
