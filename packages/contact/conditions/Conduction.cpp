#include "contact/conditions/Conduction.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::Vec2;

namespace {

/// The elements with as many flows as degrees, of a degree whose integral is one, too.
bem::Mesh meshOfHeat(const bem::Mesh& mesh, const ThermalConditions& kinds) {
  std::vector<bem::Piece> pieces;
  bem::Index size = 0;
  for (const bem::Element& element : mesh.elements()) {
    pieces.push_back(element.piece);
    pieces.back().degree = std::min(element.degree, bem::largestDegree - 1);
    size += pieces.back().degree;
  }
  if (size > Conduction::largestSize)
    throw bem::InputError(
        kinds.path, ": conduction by dense operators takes at most ",
        Conduction::largestSize, " degrees of all elements together, the mesh has ", size,
        "; make it coarser, or set Adaptivity->Maximum Degrees of Freedom");
  return {mesh.sharedOutline(), pieces};
}

std::vector<bool> isHeld(const bem::Mesh& mesh, const ThermalConditions& kinds) {
  std::vector<bool> held;
  for (int e = 0; e < mesh.size(); ++e)
    held.push_back(kinds.temperatures.count(mesh.boundary(e)) > 0);
  return held;
}

void checkMeeting(const bem::Mesh& mesh, const ThermalConditions& now) {
  const auto given = [&](int e, double t) {
    return now.temperatures.at(mesh.boundary(e))(mesh.physicalPoint(e, t));
  };
  double largest = 0;
  const std::vector<bool> held = isHeld(mesh, now);
  for (int e = 0; e < mesh.size(); ++e)
    if (held[bem::at(e)])
      largest = std::max({largest, std::abs(given(e, -1)), std::abs(given(e, 1))});
  for (int e = 0; e < mesh.size(); ++e) {
    const int next = mesh[e].next;
    if (!held[bem::at(e)] || !held[bem::at(next)])
      continue;
    const double arriving = given(e, 1);
    const double leaving = given(next, -1);
    const Vec2 x = mesh.physicalPoint(e, 1);
    if (std::abs(arriving - leaving) > 1e-8 * largest)
      throw bem::InputError(now.path, ": '", mesh.boundary(e), "' and '",
                            mesh.boundary(next), "' meet at (x, y) = (", x.x, ", ", x.y,
                            ") with the temperatures ", arriving, " and ", leaving,
                            "; a temperature does not jump");
  }
}

}  // namespace

Conduction::Conduction(const bem::Mesh& mesh, const ThermalConditions& kinds)
    : space_(meshOfHeat(mesh, kinds)), laplace_(space_, isHeld(mesh, kinds)) {}

std::shared_ptr<const ConductedHeat> Conduction::heat(
    const ThermalConditions& now) const {
  const bem::Mesh& mesh = space_.mesh();
  const double scale = mesh.outline().scaling().length / now.conductivity;
  checkMeeting(mesh, now);
  bem::HarmonicData data{bem::Vector(bem::at(space_.displacements() / 2)),
                         bem::Vector(bem::at(space_.densities() / 2))};
  bem::Vector errors(bem::at(mesh.size()));
  const auto integrate = [&](int e, const auto& f) {
    const bem::Rule& rule = bem::gaussForGiven(mesh[e].degree);
    double sum = 0;
    for (int q = 0; q < rule.size(); ++q)
      sum += mesh[e].half * rule.weights[q] * f(rule.points[q]);
    return sum;
  };
  for (const auto& [name, given] : now.flows)
    for (const int e : mesh.elementsOf(name)) {
      const auto flow = [&, &given = given](double t) {
        return scale * given(mesh.physicalPoint(e, t));
      };
      bem::LegendreSeries<double> series{};
      for (int i = 0; i < mesh[e].densities; ++i) {
        const auto term = [&](double t) {
          double legendre[bem::largestDegree + 1];
          bem::legendreValues(i, t, legendre);
          return legendre[i] * flow(t);
        };
        series[bem::at(i)] = (i + 0.5) / mesh[e].half * integrate(e, term);
        data.flow[bem::at(bem::HarmonicData::flowOf(space_, e, i))] = series[bem::at(i)];
      }
      const double size = 2 * mesh[e].half / mesh[e].degree;
      errors[bem::at(e)] =
          size * size * integrate(e, [&](double t) {
            return std::pow(flow(t) - bem::evaluate(series, mesh[e].densities - 1, t), 2);
          });
    }
  for (const auto& [name, given] : now.temperatures) {
    const std::vector<int> elements = mesh.elementsOf(name);
    const auto at = [&, &given = given](int e, double t) {
      return given(mesh.physicalPoint(e, t));
    };
    const bem::Vector values = space_.interpolatePlaces(elements, [&](int e, double t) {
      return Vec2{at(e, t), 0};
    });
    for (const int e : elements) {
      for (int k = 0; k <= mesh[e].degree; ++k)
        data.potential[bem::at(bem::HarmonicData::potentialOf(space_, e, k))] =
            values[bem::at(space_.displacement(e, k, 0))];
      errors[bem::at(e)] = integrate(e, [&](double t) {
        double phi[bem::largestDegree + 1];
        bem::DisplacementBasis::values(mesh[e].degree, t, phi);
        double missed = at(e, t);
        for (int k = 0; k <= mesh[e].degree; ++k)
          missed -= phi[k] * values[bem::at(space_.displacement(e, k, 0))];
        return missed * missed;
      });
    }
  }
  return std::make_shared<const ConductedHeat>(space_, laplace_.solve(data),
                                               std::move(errors));
}

}  // namespace epafi::contact
