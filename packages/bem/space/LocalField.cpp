#include "bem/space/LocalField.hpp"

namespace epafi::bem {

LocalField localField(const Space& space, const Vector& u, const Vector& psi, int e) {
  const Element& element = space.mesh()[e];
  const int p = element.degree;
  const auto complex = [&](const Vector& x, Index first) {
    return Complex(x[first], space.components() == 2 ? x[first + 1] : 0);
  };
  const auto coefficient = [&](int k) { return complex(u, space.displacement(e, k, 0)); };
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
  for (int i = 0; i < element.densities; ++i)
    field.density[i] = complex(psi, space.density(e, i, 0));
  return field;
}

}  // namespace epafi::bem
