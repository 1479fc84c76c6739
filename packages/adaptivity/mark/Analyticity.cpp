#include "adaptivity/mark/Analyticity.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/space/LocalField.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::adaptivity {

namespace {

using bem::Vector;

/// Legendre coefficients of one component, degree + 1 of them.
template <class Series>
Vector seriesOf(const Series& field, int degree, int component) {
  Vector series;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
    series.push_back(component == 0 ? field[k].real() : field[k].imag());
  return series;
}

}  // namespace

bool decays(const Vector& coefficients, double floor, double threshold) {
  const auto n = static_cast<double>(coefficients.size());
  if (n < 2 || bem::largestEntry(coefficients) <= floor)
    return true;
  const double middle = 0.5 * (n - 1);
  double product = 0;
  double square = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const double arm = static_cast<double>(k) - middle;
    const double size = std::max({std::abs(coefficients[k]), floor, 1e-300});
    product -= arm * std::log(size);
    square += arm * arm;
  }
  return std::exp(-product / square) <= threshold;
}

std::vector<bool> looksAnalytic(const bem::Space& space,
                                const contact::Conditions& conditions,
                                const Vector& displacement, const Vector& density,
                                double threshold) {
  constexpr double rounding = 1e-13;
  const double displacementFloor = rounding * bem::largestEntry(displacement);
  const double densityFloor = rounding * bem::largestEntry(density);
  const bem::Mesh& mesh = space.mesh();
  const Vector inner = space.withoutRotation(displacement);
  std::vector<bool> result;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::LocalField field = bem::localField(space, inner, density, e);
    const bem::Vec2 given = conditions.given(mesh.boundary(e));
    bool all = true;
    for (int component = 0; component < 2; ++component) {
      const bool isGiven = (component == 0 ? given.x : given.y) != 0;
      const int p = mesh[e].degree;
      all = all && (isGiven ? decays(seriesOf(field.density, p - 1, component),
                                     densityFloor, threshold)
                            : decays(seriesOf(field.value, p, component),
                                     displacementFloor, threshold));
    }
    result.push_back(all);
  }
  return result;
}

}  // namespace epafi::adaptivity
