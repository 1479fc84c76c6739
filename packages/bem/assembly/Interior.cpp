#include "bem/assembly/Interior.hpp"

#include "bem/potential/RelativeTarget.hpp"
#include "bem/potential/Traction.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

/// Legendre coefficients of u, u' (by arc length) and ψ on one element.
struct LocalField {
  std::array<Complex, largestDegree + 1> value{};
  std::array<Complex, largestDegree + 1> slope{};
  std::array<Complex, largestDegree + 1> density{};
};

LocalField localField(const Space& space, const Vector& u, const Vector& psi, int e) {
  const Element& element = space.mesh()[e];
  const int p = element.degree;
  const auto coefficient = [&](int k) {
    return Complex(u[space.displacement(e, k, 0)], u[space.displacement(e, k, 1)]);
  };
  LocalField field;
  const Complex start = coefficient(0);
  const Complex end = coefficient(1);
  field.value[0] = 0.5 * (start + end);
  field.value[1] = 0.5 * (end - start);
  field.slope[0] = 0.5 * (end - start) / element.half;
  for (int k = 2; k <= p; ++k) {
    const double slope = DisplacementBasis::slope(k);
    field.value[k] += slope / (2 * k - 1) * coefficient(k);
    field.value[k - 2] -= slope / (2 * k - 1) * coefficient(k);
    field.slope[k - 1] = slope / element.half * coefficient(k);
  }
  for (int i = 0; i < p; ++i)
    field.density[i] = {psi[space.density(e, i, 0)], psi[space.density(e, i, 1)]};
  return field;
}

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
