#include "contact/body/Coupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// Adds a point of a contact element, t on an element, its own or an opposite one, to what the
/// coefficients do to the displacements of that one, by coefficients: ∫ χ_i d·φ_k, the components of
/// φ_k in a row, and last ∫ χ_i d·(r - r_I), less what turns of arcs do.
/// \param turn  of directions, of the element's body
void addPoint(const SidePoint& point, double weight, const bem::Space& space, int element,
              double t, double Direction::*turn, Matrix& works) {
  const int degree = space.mesh()[element].degree;
  if (works.empty())
    works = Matrix(2 * (degree + Index{1}) + 1, point.contact.coefficients());
  std::array<double, bem::largestDegree + 1> phi{};
  bem::DisplacementBasis::values(degree, t, phi.data());
  const Vec2 rest = space.rotationRest(element, t);
  for (int i = 0; i < point.contact.coefficients(); ++i) {
    const Direction& direction = point.directionOf(i);
    const double value = weight * point.chiOf(i);
    const Vec2 force = value * direction.unit;
    double* column = works.column(i);
    for (int k = 0; k <= degree; ++k) {
      column[2 * k] += force.x * phi[at(k)];
      column[2 * k + 1] += force.y * phi[at(k)];
    }
    column[works.rows() - 1] += dot(force, rest) - value * direction.*turn;
  }
}

using Entries = std::map<std::pair<Index, Index>, double>;

/// Adds the works of a contact element on an element; apart, what completes ends.
void addWorks(const Matrix& works, const ContactElement& contact, const bem::Space& space,
              int element, TraceCoupling& trace, Entries& completed) {
  const Index last = works.rows() - 1;
  // of coefficient i, as a part of those of another one
  const auto add = [&](Index number, double factor, int i, bool completes) {
    trace.rests[at(number)] += factor * works(last, i);
    for (Index k = 0; k < last; ++k) {
      const Index row =
          space.displacement(element, static_cast<int>(k / 2), static_cast<int>(k % 2));
      if (completes)
        completed[{row, number}] += factor * works(k, i);
      else
        trace.entries.push_back({row, number, factor * works(k, i)});
    }
  };
  for (int i = 0; i < contact.coefficients(); ++i) {
    const int k = contact.functionOf(i);
    const Coefficients& own = contact.of(i);
    add(contact.numberOf(i), 1, i, own.holdsNothing(k));
    for (const std::size_t end : {0, 1})
      if (k == (end == 0 ? 0 : contact.degree))
        for (const auto& [other, factor] : own.ends[end].added)
          add(other, factor, i, true);
  }
}

/// Only where displacements are prescribed do completed ends do more than quadrature on arcs leaves.
void addCompleted(const Entries& completed, const std::vector<char>& held,
                  Coupling& coupling) {
  constexpr double rounding = 1e-15;  // of straight sides
  for (const auto& [place, value] : completed)
    if (const auto [row, number] = place; held[at(row)] != 0)
      coupling.completion.entries.push_back({row, number, value});
    else if (std::abs(value) > rounding)
      coupling.trace.entries.push_back({row, number, value});
}

void checkEnds(const ContactElement& element, const MultiplierBasis& basis) {
  for (const Coefficients* own : {&element.normal, &element.tangential})
    for (const Coefficients::End& end : own->ends)
      if (end.clamped || !end.added.empty())
        throw bem::InputError(
            "the multiplier '", basis.name,
            "' cannot end at a clamp or at another contact side where it stands "
            "between two bodies; use Gauss-Legendre-Lagrange or Bernstein");
}

}  // namespace

std::vector<Coupling> makeCouplings(const std::vector<const bem::Space*>& spaces,
                                    const MultiplierSpace& multiplier,
                                    const Opposite& opposite) {
  const Vector zero(at(multiplier.size()));
  std::vector<Coupling> couplings(spaces.size());
  std::vector<Entries> completed(spaces.size());
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    couplings[b].opposite = &opposite;
    couplings[b].trace = {{}, spaces[b]->rotation(), zero};
    couplings[b].completion = {{}, nullptr, zero};
  }
  multiplier.forEachElement([&](const ContactElement& contact) {
    std::map<std::pair<int, int>, Matrix> all;  // works by body and element
    for (const Stretch& stretch : stretches(opposite, contact)) {
      const Opposite::Point middle = opposite.at(contact, stretch.middle);
      if (middle.element >= 0)
        checkEnds(contact, multiplier.basis());
      forEachPointOf(
          contact, multiplier.basis(), ruleOfForces(contact, middle),
          [&](const SidePoint& point) {
            addPoint(point, point.weight, *spaces[at(contact.body)], contact.element,
                     point.t, &Direction::ownTurn, all[{contact.body, contact.element}]);
            if (const Opposite::Point& there = point.opposite; there.element >= 0)
              addPoint(point, -point.weight, *spaces[at(there.body)], there.element,
                       there.t, &Direction::oppositeTurn,
                       all[{there.body, there.element}]);
          },
          stretch);
    }
    for (const auto& [where, works] : all) {
      const std::size_t b = at(where.first);
      addWorks(works, contact, *spaces[b], where.second, couplings[b].trace,
               completed[b]);
    }
  });
  for (std::size_t b = 0; b < spaces.size(); ++b)
    if (!completed[b].empty())
      addCompleted(completed[b], prescribed(*spaces[b], multiplier.conditions(b)),
                   couplings[b]);
  return couplings;
}

std::vector<Index> Coupling::columns() const {
  const Vector& rests = trace.rests;
  std::vector<char> acts(rests.size());
  for (const auto* entries : {&trace.entries, &weights, &mass})
    for (const bem::Entry& entry : *entries)
      acts[at(entry.column)] = 1;
  std::vector<Index> result;
  for (std::size_t i = 0; i < acts.size(); ++i)
    if (acts[i] != 0 || rests[i] != 0)
      result.push_back(static_cast<Index>(i));
  return result;
}

void Coupling::weaken(double newGamma0) {
  const double factor = newGamma0 / gamma0;
  gamma0 = newGamma0;
  for (auto* entries : {&weights, &mass})
    for (bem::Entry& entry : *entries)
      entry.value *= factor;
  for (double& g : gamma)
    g *= factor;
}

Vector Coupling::massTimes(const Vector& lambda) const {
  Vector result(lambda.size());
  for (const bem::Entry& entry : mass)
    result[at(entry.row)] += entry.value * lambda[at(entry.column)];
  return result;
}

Vector Coupling::weighted(const Vector& lambda) const {
  Vector result(at(start.back()));
  for (std::size_t k = 0; k < weights.size() && !lambda.empty(); ++k)
    result[at(weights[k].row)] += weights[k].value * lambda[at(weights[k].column)];
  return result;
}

void Coupling::subtractWeighted(const Vector& w, Vector& r) const {
  for (const bem::Entry& entry : weights)
    r[at(entry.column)] -= entry.value * w[at(entry.row)];
}

Vector Coupling::onDensities(const Vector& w, Index densities) const {
  Vector result(at(densities));
  for (std::size_t k = 0; k < compliance.densities.size(); ++k)
    result[at(compliance.densities[k])] = w[k];
  return result;
}

Vector Coupling::ofDensities(const Vector& density) const {
  Vector result;
  for (const Index i : compliance.densities)
    result.push_back(density[at(i)]);
  return result;
}

TraceCoupling Coupling::withDensities(Index displacements) const {
  TraceCoupling all = trace;
  for (const auto& [row, column, value] : weights)
    all.entries.push_back(
        {displacements + compliance.densities[at(row)], column, -value});
  return all;
}

double Coupling::complianceWork(const Vector& density) const {
  double work = 0;
  for (std::size_t k = 0; k < compliance.densities.size(); ++k)
    work += compliance.diagonal[k] * std::pow(density[at(compliance.densities[k])], 2);
  for (const auto& [i, value] : compliance.pinned)
    work += value * std::pow(density[at(i)], 2);
  return work;
}

Vector Coupling::complianceOf(const bem::Space& space, const Vector& onContacts,
                              const BoundaryTraction& traction) const {
  const bem::Mesh& mesh = space.mesh();
  Vector result = onDensities(onContacts, space.densities());
  const bem::Rule& rule = bem::gaussForGiven(0);
  for (const auto& [i, value] : compliance.pinned)
    for (int e = 0; e < mesh.size(); ++e)
      for (const int c : {0, 1})
        for (int q = 0; q < rule.size() && space.density(e, 0, c) == i; ++q) {
          const Vec2 there = traction(e, rule.points[q]);
          result[at(i)] += value * 0.5 * rule.weights[q] * (c == 0 ? there.x : there.y);
        }
  return result;
}

std::vector<Vec2> Coupling::meanSlacks(const Vector& lambda, const Vector& density,
                                       const Vector& ofInside) const {
  std::vector<Vec2> means(gamma.size());
  if (!byDensity())
    return means;
  // P_0 is 1: its rows of N λ and of G ψ are integrals
  Vector w = weighted(lambda);
  if (!ofInside.empty())
    bem::axpy(1, ofDensities(ofInside), w);
  const Vector psi = ofDensities(density);
  for (std::size_t c = 0; c < means.size(); ++c) {
    const std::size_t first = at(start[c]);
    const auto integral = [&](std::size_t k) {
      return w[k] + compliance.diagonal[k] * psi[k];
    };
    const double length = compliance.diagonal[first] / gamma[c];
    means[c] = (1 / length) * Vec2{integral(first), integral(first + 1)};
  }
  return means;
}

}  // namespace epafi::contact
