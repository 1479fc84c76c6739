#include "drivers/study/TrueError.hpp"

#include "bem/base/Error.hpp"
#include "bem/operators/EnergyNorm.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/Numbering.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::drivers {

namespace {

using Series = bem::LegendreSeries<bem::Complex>;

/// Σ h/p ‖λ - λ_ref‖² over the contact elements of the level, h/d for h.
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

/// Displacement, density and multiplier of a body as functions.
BodySnapshot bodySnapshot(const BodySpaces& spaces, std::size_t b,
                          const bem::Vector& displacement, const bem::Vector& density,
                          const bem::Vector& multiplier) {
  const bem::Space& space = spaces.space(b);
  const contact::MultiplierSpace& own = spaces.multiplier(b);
  const std::size_t elements = space.mesh().size();
  BodySnapshot body{bem::makeCauchyData(space, displacement, density),
                    std::vector<Series>(elements), std::vector<bool>(elements)};
  for (const auto& element : own.elements()) {
    body.contact[element.element] = true;
    body.multiplier[element.element] = bem::project(
        [&](double t) {
          const auto value = own.at(multiplier, element, t);
          return bem::Complex(value.normal, value.tangential);
        },
        element.degree);
  }
  return body;
}

/// The state of the path at a requested time, of all bodies together.
const contact::State& stateAt(const Level& level, double t) {
  for (const PathPoint& point : level.path)
    if (point.t == t)
      return point.state;
  throw bem::NumericalError(
      bem::message("the path has no state at t = ", t, ", which it was asked for"));
}

/// Distance at one time, dimensionless.
struct Distance {
  double norm = 0;
  double multiplier = 0;
};

Distance distanceOf(const Snapshot& level, const Snapshot& reference,
                    const Scene& scene) {
  Distance distance;
  double squares = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const bem::Lame lame = scene.lame(b);
    const BodySnapshot& own = level.bodies[b];
    const BodySnapshot& other = reference.bodies[b];
    distance.norm = std::hypot(
        distance.norm, bem::energyNorm(bem::difference(own.data, other.data), lame));
    squares += multiplierDistance(own, other) / lame.mu;
  }
  distance.multiplier = std::sqrt(squares);
  return distance;
}

}  // namespace

Snapshots takeSnapshots(const Scene& scene, const Level& level, double energy,
                        const std::vector<double>& dissipated) {
  const BodySpaces spaces(scene, level);
  const contact::Numbering numbering(spaces.sides());
  Snapshots result{{}, energy};
  for (const StepFields& step : level.steps) {
    Snapshot& snapshot = result.steps.emplace_back();
    const contact::State* all = nullptr;
    if (level.onPath()) {
      all = &stateAt(level, step.t);
      snapshot.t = step.t;
      snapshot.dissipated = dissipated.at(result.steps.size() - 1);
    }
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      bem::Vector own = level.last().own[b].multiplier;
      for (std::size_t i = 0; i < own.size() && all != nullptr; ++i)
        own[i] = all->multiplier[numbering(b, static_cast<bem::Index>(i))];
      snapshot.bodies.push_back(
          bodySnapshot(spaces, b, step.displacement[b], step.density[b], own));
    }
  }
  return result;
}

Reference::Reference(Snapshots snapshots, double estimate_, const Scene& scene)
    : solution(std::move(snapshots)), estimate(estimate_) {
  for (const Snapshot& step : solution.steps) {
    double norm = 0;
    for (std::size_t b = 0; b < step.bodies.size(); ++b)
      norm = std::hypot(norm, bem::energyNorm(step.bodies[b].data, scene.lame(b)));
    norms.push_back(norm);
  }
}

TrueError trueError(const Snapshots& level, const Reference& reference,
                    const Scene& scene) {
  const double unit = std::sqrt(scene.energy());
  const std::vector<Snapshot>& others = reference.solution.steps;
  const Distance last = distanceOf(level.steps.back(), others.back(), scene);
  TrueError error;
  error.energyNorm = last.norm * unit;
  error.relative = last.norm / reference.norms.back();
  error.multiplier = last.multiplier / reference.norms.back();
  error.energy = std::abs(level.energy / reference.solution.energy - 1);
  error.largest = error.energyNorm;
  if (!scene.history)
    return error;
  const double largest =
      *std::max_element(reference.norms.begin(), reference.norms.end());
  const double work = std::abs(others.back().dissipated);
  TrueError::Path path;
  for (std::size_t k = 0; k < level.steps.size(); ++k) {
    const Snapshot& step = level.steps[k];
    const auto other = std::find_if(others.begin(), others.end(), [&](const auto& s) {
      return std::abs(s.t - step.t) <= 1e-9 * step.t;
    });
    if (other == others.end())
      continue;
    const Distance distance = distanceOf(step, *other, scene);
    if (path.step == 0 || distance.norm / largest > path.relative) {
      path.relative = distance.norm / largest;
      path.step = static_cast<int>(k) + 1;
    }
    path.multiplier = std::max(path.multiplier, distance.multiplier / largest);
    if (work > 0)
      path.friction =
          std::max(path.friction, std::abs(step.dissipated - other->dissipated) / work);
  }
  if (path.step > 0) {
    error.path = path;
    error.largest = path.relative * largest * unit;
  }
  return error;
}

}  // namespace epafi::drivers
