#include "bem/fields/Interior.hpp"

#include "bem/moments/RelativeTarget.hpp"
#include "bem/space/LocalField.hpp"
#include "bem/tractions/Traction.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

Complex singleLayer(const Lame& lame, const Element& element,
                    const RelativeTarget& target, const LegendreMoments& m, int j,
                    Complex f) {
  const Complex tangent = asComplex(element.tangent);
  const double constant = j == 0 ? 2 : 0;
  const double log = element.half * (m.l[j] + constant * std::log(element.half));
  const Complex phase =
      element.half * tangent * tangent * (constant - Complex(0, 2 * target.b()) * m.c[j]);
  return -lame.a * log * f +
         0.5 * lame.b * (constant * element.half * f + std::conj(f) * phase);
}

Complex doubleLayer(const Lame& lame, Complex normal, const ElementIntegrals& in,
                    Complex v) {
  return lame.mu * (2 * lame.b * (std::conj(normal) * v).real() * in.overConj +
                    lame.a * normal * v * in.overW +
                    lame.b * std::conj(normal) * std::conj(v) * in.cubic);
}

}  // namespace

InteriorValue evaluateInterior(const Space& space, const Lame& lame, const Vector& u,
                               const Vector& psi, Vec2 x) {
  const TractionKernel onX(lame, Complex(1, 0));
  const TractionKernel onY(lame, Complex(0, 1));
  Complex displacement = 0;
  Complex tractionX = 0;
  Complex tractionY = 0;
  LegendreMoments moments;
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const RelativeTarget target = seenFrom(element, x);
    evaluateMoments(target, element.degree, Need::All, moments);
    const LocalField field = localField(space, u, psi, e);
    for (int j = 0; j <= element.degree; ++j) {
      const ElementIntegrals in =
          elementIntegrals(asComplex(element.tangent), target, moments, j);
      displacement -= doubleLayer(lame, asComplex(element.normal), in, field.value[j]);
      if (j == element.degree)
        continue;
      displacement += singleLayer(lame, element, target, moments, j, field.density[j]);
      tractionX += onX.adjointDoubleLayer(in, field.density[j]) +
                   onX.hypersingular(in, field.slope[j]);
      tractionY += onY.adjointDoubleLayer(in, field.density[j]) +
                   onY.hypersingular(in, field.slope[j]);
    }
  }
  return {{displacement.real(), displacement.imag()},
          tractionX.real(),
          tractionY.imag(),
          0.5 * (tractionX.imag() + tractionY.real())};
}

}  // namespace epafi::bem
