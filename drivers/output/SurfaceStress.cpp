#include "drivers/output/SurfaceStress.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::drivers {

using bem::Vec2;

SurfaceField::SurfaceField(const bem::Space& space, const bem::Lame& lame,
                           const bem::Vector& u, bem::Vector psi)
    : space_(space), lame_(lame), psi_(std::move(psi)), u_(space, u) {
  const bem::Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::LocalField field = bem::localField(space, u, psi_, e);
    Samples& samples = own_.emplace_back();
    for (const double t : bem::gaussLegendre(mesh[e].degree).points) {
      const bem::Complex slope = bem::evaluate(field.slope, mesh[e].degree - 1, t);
      samples.places.push_back(t);
      samples.strains.push_back(
          dot({slope.real(), slope.imag()}, mesh[e].curve.tangent(t)));
    }
  }
  all_ = own_;
  for (int e = 0; e < mesh.size(); ++e)
    for (const bool next : {false, true})
      addNeighbour(e, next, all_[e]);
  if (mesh.outline().isAxisymmetric())
    inside_.emplace(space, lame, u, psi_);
}

void SurfaceField::addNeighbour(int element, bool next, Samples& samples) const {
  constexpr double smooth = 1e-6;
  const bem::Mesh& mesh = space_.mesh();
  const bem::Element& e = mesh[element];
  const int other = next ? e.next : e.previous;
  const double end = next ? 1 : -1;
  if (mesh.isAxis(other)) {  // beyond it is the image, with the same strains
    const Samples& own = own_[element];
    const std::size_t count = own.places.size();
    if (std::abs(e.curve.tangent(end).y) < smooth)
      for (std::size_t k = 0; k < std::min<std::size_t>(2, count); ++k) {
        const std::size_t i = next ? count - 1 - k : k;
        samples.places.push_back(2 * end - own.places[i]);
        samples.strains.push_back(own.strains[i]);
      }
    return;
  }
  const bem::Curve& beyond = mesh[other].curve;
  if (mesh.boundary(other) != mesh.boundary(element) ||
      dot(e.curve.tangent(end), beyond.tangent(-end)) < 1 - smooth)
    return;
  const Samples& there = own_[other];
  const std::size_t count = there.places.size();
  for (std::size_t k = 0; k < std::min<std::size_t>(2, count); ++k) {
    const std::size_t i = next ? k : count - 1 - k;
    samples.places.push_back(end + (there.places[i] + end) * mesh[other].half / e.half);
    samples.strains.push_back(there.strains[i]);
  }
}

double SurfaceField::strainAlong(int element, double t) const {
  const auto& [places, strains] = all_[element];
  double sum = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double value = strains[i];
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i)
        value *= (t - places[k]) / (places[i] - places[k]);
    sum += value;
  }
  return sum;
}

double SurfaceField::strainAround(int element, double t) const {
  const bem::Mesh& mesh = space_.mesh();
  if (!mesh.outline().isAxisymmetric())
    return 0;
  const double radius = mesh.scaledPoint(element, t).x;
  return radius > 0 ? u_.at(element, t).x / radius : strainAlong(element, t);
}

bem::InteriorValue SurfaceField::at(int element, double t) const {
  const bem::Mesh& mesh = space_.mesh();
  if (mesh.isAxis(element)) {
    if (std::abs(t) < 1)
      return inside_->at(mesh.scaledPoint(element, t));
    return t < 0 ? at(mesh[element].previous, 1) : at(mesh[element].next, -1);
  }
  const bem::Curve& curve = mesh[element].curve;
  const Vec2 n = curve.normal(t);
  const Vec2 tangent = curve.tangent(t);
  const Vec2 traction = space_.densityAt(psi_, element, t);
  const double normal = dot(traction, n);
  const double shear = dot(traction, tangent);
  const double nu = lame_.nu;
  const double along = strainAlong(element, t);
  const double around = strainAround(element, t);
  const double tangential =
      (2 * lame_.mu * (along + nu * around) + nu * normal) / (1 - nu);
  bem::InteriorValue value;
  value.zz = (2 * lame_.mu * (around + nu * along) + nu * normal) / (1 - nu);
  value.displacement = u_.at(element, t);
  value.xx = normal * n.x * n.x + 2 * shear * n.x * tangent.x +
             tangential * tangent.x * tangent.x;
  value.yy = normal * n.y * n.y + 2 * shear * n.y * tangent.y +
             tangential * tangent.y * tangent.y;
  value.xy = normal * n.x * n.y + shear * (n.x * tangent.y + n.y * tangent.x) +
             tangential * tangent.x * tangent.y;
  return value;
}

}  // namespace epafi::drivers
