#include "bem/space/Rotation.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/Space.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

Rotation::Rotation(const Space& space) {
  const Mesh& mesh = space.mesh();
  double length = 0;
  for (const Element& element : mesh.elements()) {
    centre_ = centre_ + 2 * element.half * element.curve.centroid();
    length += 2 * element.half;
  }
  centre_ = (1 / length) * centre_;
  motion_ = space.interpolate([this](Vec2 x) { return at(x); });
  functional_.assign(motion_.size(), 0.0);
  std::array<double, largestDegree + 1> phi{};
  for (int e = 0; e < mesh.size(); ++e) {
    const Element& element = mesh[e];
    const Rule& rule =
        gaussLegendre(element.degree + std::max(1, element.curve.pointsOfTurning()));
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const Vec2 r = at(mesh.scaledPoint(e, rule.points[q]));
      DisplacementBasis::values(element.degree, rule.points[q], phi.data());
      for (int k = 0; k <= element.degree; ++k) {
        const double weight = element.half * rule.weights[q] * phi[k];
        functional_[space.displacement(e, k, 0)] += weight * r.x;
        functional_[space.displacement(e, k, 1)] += weight * r.y;
      }
    }
  }
  const double square = amount(motion_);
  for (double& value : functional_)
    value /= square;
}

double Rotation::amount(const Vector& u) const {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i)
    sum += functional_[i] * u[i];
  return sum;
}

Vector Rotation::without(Vector u) const {
  const double omega = amount(u);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] -= omega * motion_[i];
  return u;
}

void Rotation::complete(double rest, Vector& functional) const {
  for (std::size_t i = 0; i < functional.size(); ++i)
    functional[i] += rest * functional_[i];
}

}  // namespace epafi::bem
