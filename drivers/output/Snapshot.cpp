#include "drivers/output/Snapshot.hpp"

#include "bem/operators/EnergyNorm.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/problem/ContactProblem.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using Series = bem::LegendreSeries<bem::Complex>;

/// Σ h/p ‖λ - λ_ref‖² over the level's contact elements; h: lengths over the diameter.
double multiplierDistance(const Snapshot& level, const Snapshot& reference) {
  const bem::UnionMesh both = bem::unite(level.data.mesh, reference.data.mesh);
  double sum = 0;
  for (int e = 0; e < both.mesh.size(); ++e) {
    const bem::Origin& a = both.first[static_cast<std::size_t>(e)];
    const bem::Origin& b = both.second[static_cast<std::size_t>(e)];
    const auto k = static_cast<std::size_t>(a.element);
    if (!level.contact[k])
      continue;
    const bem::Element& own = level.data.mesh[a.element];
    const int p = reference.data.mesh[b.element].degree;
    const bem::Rule& rule = bem::gaussLegendre(std::max(own.degree, p) + 1);
    double square = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      square +=
          rule.weights[q] *
          std::norm(
              bem::evaluate(level.multiplier[k], own.degree, a.middle + a.scale * t) -
              bem::evaluate(reference.multiplier[static_cast<std::size_t>(b.element)], p,
                            b.middle + b.scale * t));
    }
    sum += 2 * own.half / own.degree * both.mesh[e].half * square;
  }
  return sum;
}

}  // namespace

Snapshot takeSnapshot(const Scene& scene, const Level& level, double energy) {
  const bem::Space space = contact::makeSpace({scene.outline, level.pieces},
                                              scene.conditions, scene.stabilization);
  const contact::MultiplierSpace multiplier(
      space.mesh(), contact::multiplierBasis(scene.multiplier), scene.conditions);
  const auto elements = static_cast<std::size_t>(space.mesh().size());
  Snapshot snapshot{bem::makeCauchyData(space, level.displacement, level.density),
                    std::vector<Series>(elements), std::vector<bool>(elements), energy};
  for (const auto& element : multiplier.elements()) {
    const auto k = static_cast<std::size_t>(element.element);
    snapshot.contact[k] = true;
    snapshot.multiplier[k] = bem::project(
        [&](double t) {
          const auto value = multiplier.at(level.state.multiplier, element, t);
          return bem::Complex(value.normal, value.tangential);
        },
        element.degree);
  }
  return snapshot;
}

TrueError trueError(const Snapshot& level, const Snapshot& reference,
                    const bem::Lame& lame, const bem::Units& units) {
  const double size = bem::energyNorm(reference.data, lame);
  const double distance =
      bem::energyNorm(bem::difference(level.data, reference.data), lame);
  TrueError error;
  error.energyNorm = distance * std::sqrt(units.stress) * units.length;
  error.relative = distance / size;
  error.multiplier = std::sqrt(multiplierDistance(level, reference) / lame.mu) / size;
  error.energy = std::abs(level.energy / reference.energy - 1);
  return error;
}

}  // namespace epafi::drivers
