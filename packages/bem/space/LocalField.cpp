#include "bem/space/LocalField.hpp"

namespace epafi::bem {

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
  for (int i = 0; i < element.densities; ++i)
    field.density[i] = {psi[space.density(e, i, 0)], psi[space.density(e, i, 1)]};
  return field;
}

}  // namespace epafi::bem
