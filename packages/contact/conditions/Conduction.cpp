#include "contact/conditions/Conduction.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/conditions/RingHeat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

using bem::at;
using bem::Vec2;

namespace {

/// A degree whose integral is one, too.
int degreeOfHeat(const bem::Element& element) {
  return std::min(element.degree, bem::largestDegree - 1);
}

/// The elements with as many flows as degrees.
bem::Mesh meshOfHeat(const bem::Mesh& mesh) {
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements()) {
    pieces.push_back(element.piece);
    pieces.back().degree = degreeOfHeat(element);
  }
  return {mesh.sharedOutline(), pieces};
}

std::vector<bool> isHeld(const bem::Mesh& mesh, const ThermalConditions& kinds) {
  std::vector<bool> held;
  held.reserve(at(mesh.size()));
  for (int e = 0; e < mesh.size(); ++e)
    held.push_back(kinds.temperatures.count(mesh.boundary(e)) > 0);
  return held;
}

/// As good as what gaussForGiven sees of it.
bem::LegendreSeries<double> seriesOf(const bem::Function& given, const bem::Mesh& mesh,
                                     int e) {
  return bem::project([&](double t) { return given(mesh.physicalPoint(e, t)); },
                      bem::largestDegree);
}

/// ∫ of its square over an element, with the radius of its middle.
double square(const bem::LegendreSeries<double>& series, const bem::Mesh& mesh, int e) {
  double sum = 0;
  for (std::size_t k = 0; k < series.size(); ++k)
    sum += mesh.measure(e, 0) * series[k] * series[k] / (static_cast<double>(k) + 0.5);
  return sum;
}

}  // namespace

Conduction::Conduction(const bem::Mesh& mesh, const ThermalConditions& kinds)
    : space_(meshOfHeat(mesh), 1),
      laplace_(space_, isHeld(mesh, kinds)),
      places_(mesh.outline().isAxisymmetric()
                  ? RingHeat::placesInHoles(mesh)
                  : PlaneHeat::placesInHoles(mesh.outline())) {}

std::shared_ptr<const ConductedHeat> Conduction::heat(
    const ThermalConditions& now) const {
  const bem::Mesh& mesh = space_.mesh();
  const double scale = mesh.outline().scaling().length / now.conductivity;
  bem::Vector data(at(space_.displacements() + space_.densities()));
  bem::Vector errors(at(mesh.size()));
  for (const auto& [name, given] : now.flows)
    for (const int e : mesh.elementsOf(name)) {
      bem::LegendreSeries<double> rest = seriesOf(given, mesh, e);
      for (int i = 0; i < mesh[e].densities; ++i)
        data[at(flowOf(space_, e, i))] = scale * std::exchange(rest[at(i)], 0.0);
      errors[at(e)] =
          std::pow(scale * 2 * mesh[e].half / mesh[e].degree, 2) * square(rest, mesh, e);
    }
  std::vector<bool> isKnown(data.size(), false);
  double largest = 0;
  for (const auto& [name, given] : now.temperatures) {
    const std::vector<int> elements = mesh.elementsOf(name);
    const bem::Vector values =
        space_.interpolatePlaces(elements, [&, &given = given](int e, double t) {
          return Vec2{given(mesh.physicalPoint(e, t)), 0};
        });
    largest = std::max(largest, bem::largestEntry(values));
    for (const int e : elements) {
      bem::LegendreSeries<double> rest = seriesOf(given, mesh, e);
      const bem::Matrix phi =
          bem::DisplacementBasis::legendreCoefficients(mesh[e].degree);
      for (int k = 0; k <= mesh[e].degree; ++k) {
        const std::size_t unknown = at(potentialOf(space_, e, k));
        const double value = values[at(space_.displacement(e, k, 0))];
        const Vec2 x = mesh.physicalPoint(e, k == 0 ? -1 : 1);
        if (isKnown[unknown] && std::abs(value - data[unknown]) > 1e-8 * largest)
          throw bem::InputError(now.path, "->", name, ": is ", value, " at (x, y) = (",
                                x.x, ", ", x.y, "), where another boundary is ",
                                data[unknown], "; a temperature does not jump");
        isKnown[unknown] = true;
        data[unknown] = value;
        for (int j = 0; j <= mesh[e].degree; ++j)
          rest[at(j)] -= phi(j, k) * value;
      }
      errors[at(e)] = square(rest, mesh, e);
    }
  }
  data = laplace_.solve(std::move(data));
  if (mesh.outline().isAxisymmetric())
    return std::make_shared<const RingHeat>(space_, data, places_, std::move(errors));
  return std::make_shared<const PlaneHeat>(space_, data, places_, std::move(errors));
}

}  // namespace epafi::contact
