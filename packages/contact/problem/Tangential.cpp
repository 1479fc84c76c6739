#include "contact/problem/Tangential.hpp"

#include <utility>

namespace epafi::contact {

Tangential Tangential::scaled(double factor) const {
  Tangential result = *this;
  if (!isTied())
    result.scale(factor);
  return result;
}

std::vector<Tangential> elementTangentials(const MultiplierBasis& basis,
                                           const std::vector<Index>& normals,
                                           const std::shared_ptr<const FrictionLaw>& law,
                                           const std::function<Vector(double)>& fields,
                                           double stress) {
  const int degree = static_cast<int>(normals.size()) - 1;
  std::vector<Tangential> result;
  if (!law->dependsOnPressure()) {
    const Vector bounds = boundCoefficients(
        basis, degree, [&](double t) { return law->bound(0, fields(t)) / stress; });
    for (std::size_t i = 0; i < normals.size(); ++i)
      result.emplace_back(normals[i], PointLaw(bounds[i]));
    return result;
  }
  std::vector<Vector> coefficients(fields(0).size());
  for (std::size_t f = 0; f < coefficients.size(); ++f)
    coefficients[f] =
        boundCoefficients(basis, degree, [&](double t) { return fields(t)[f]; });
  for (std::size_t i = 0; i < normals.size(); ++i) {
    Vector here;
    for (const Vector& field : coefficients)
      here.push_back(field[i]);
    result.emplace_back(normals[i], PointLaw(law, std::move(here), stress));
  }
  return result;
}

}  // namespace epafi::contact
