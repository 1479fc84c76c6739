#include "drivers/study/TrueError.hpp"

#include "bem/operators/EnergyNorm.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using Series = bem::LegendreSeries<bem::Complex>;

/// Σ h/p ‖λ - λ_ref‖² over the level's contact elements; h: lengths over the diameter.
double multiplierDistance(const BodySnapshot& level, const BodySnapshot& reference) {
  const bem::UnionMesh both = bem::unite(level.data.mesh, reference.data.mesh);
  double sum = 0;
  for (int e = 0; e < both.mesh.size(); ++e) {
    const bem::Origin& a = both.first[e];
    const bem::Origin& b = both.second[e];
    if (!level.contact[a.element])
      continue;
    const bem::Element& own = level.data.mesh[a.element];
    const int p = reference.data.mesh[b.element].degree;
    const bem::Rule& rule = bem::gaussLegendre(std::max(own.degree, p) + 1);
    double square = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      square +=
          rule.weights[q] * std::norm(bem::evaluate(level.multiplier[a.element],
                                                    own.degree, a.middle + a.scale * t) -
                                      bem::evaluate(reference.multiplier[b.element], p,
                                                    b.middle + b.scale * t));
    }
    sum += 2 * own.half / own.degree * both.mesh[e].half * square;
  }
  return sum;
}

}  // namespace

Snapshot takeSnapshot(const Scene& scene, const Level& level, double energy) {
  const BodySpaces spaces(scene, meshesOf(scene, level));
  Snapshot snapshot{{}, energy};
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = spaces.space(b);
    const contact::MultiplierSpace& multiplier = spaces.multiplier(b);
    const BodyLevel& own = level.bodies[b];
    const std::size_t elements = space.mesh().size();
    BodySnapshot body{bem::makeCauchyData(space, own.displacement, own.density),
                      std::vector<Series>(elements), std::vector<bool>(elements)};
    for (const auto& element : multiplier.elements()) {
      body.contact[element.element] = true;
      body.multiplier[element.element] = bem::project(
          [&](double t) {
            const auto value = multiplier.at(own.state.multiplier, element, t);
            return bem::Complex(value.normal, value.tangential);
          },
          element.degree);
    }
    snapshot.bodies.push_back(std::move(body));
  }
  return snapshot;
}

TrueError trueError(const Snapshot& level, const Snapshot& reference,
                    const Scene& scene) {
  const bem::Units units = scene.units();
  double size = 0;
  double distance = 0;
  double multiplier = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bem::Lame lame = scene.lame(b);
    const BodySnapshot& own = level.bodies[b];
    const BodySnapshot& other = reference.bodies[b];
    size = std::hypot(size, bem::energyNorm(other.data, lame));
    distance = std::hypot(distance,
                          bem::energyNorm(bem::difference(own.data, other.data), lame));
    multiplier += multiplierDistance(own, other) / lame.mu;
  }
  TrueError error;
  error.energyNorm = distance * std::sqrt(units.stress) * units.length;
  error.relative = distance / size;
  error.multiplier = std::sqrt(multiplier) / size;
  error.energy = std::abs(level.energy / reference.energy - 1);
  return error;
}

}  // namespace epafi::drivers
