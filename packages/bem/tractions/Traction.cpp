#include "bem/tractions/Traction.hpp"

namespace epafi::bem {

ElementIntegrals elementIntegrals(Complex tangent, const RelativeTarget& target,
                                  const LegendreMoments& moments, int j) {
  const Complex c = moments.c[j];
  const Complex turned = tangent * c;
  // on the element's own line b = 0, and d need not exist
  const Complex cubic =
      target.b() == 0 ? c : c - Complex(0, 2 * target.b()) * moments.d[j];
  return {std::conj(turned), turned, tangent * tangent * tangent * cubic};
}

Complex TractionKernel::adjointDoubleLayer(const ElementIntegrals& in, Complex f) const {
  return -2 * lame_.mu * lame_.b * (f * in.overW).real() * normal_ -
         lame_.mu * std::conj(normal_) *
             (lame_.a * f * in.overConj + lame_.b * std::conj(f) * in.cubic);
}

Complex TractionKernel::hypersingular(const ElementIntegrals& in, Complex slope) const {
  const Complex tangent = Complex(0, 1) * normal_;
  return lame_.d * ((tangent * in.overW).real() * slope -
                    0.5 * std::conj(slope) *
                        (tangent * in.overConj - std::conj(tangent) * in.cubic));
}

}  // namespace epafi::bem
