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

/// What the coefficients of a contact element, in a row, do to the displacements of an element, its
/// own or an opposite one.
class Works {
 public:
  /// \param turn  that of directions, of the element's body
  Works(const ContactElement& contact, const bem::Space& space, int element,
        double Direction::*turn)
      : contact_(contact),
        space_(space),
        element_(element),
        turn_(turn),
        traces_(2 * (space.mesh()[element].degree + Index{1}), contact.coefficients()),
        rests_(at(contact.coefficients())) {}

  /// Adds a point of the side, t on the element.
  void add(const SidePoint& point, double weight, double t) {
    const int degree = space_.mesh()[element_].degree;
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(degree, t, phi.data());
    const Vec2 rest = space_.rotationRest(element_, t);
    for (int i = 0; i < contact_.coefficients(); ++i) {
      const Direction& direction = point.directionOf(i);
      const double value = weight * point.chiOf(i);
      const Vec2 force = value * direction.unit;
      double* trace = traces_.column(i);
      for (int k = 0; k <= degree; ++k) {
        trace[2 * k] += force.x * phi[at(k)];
        trace[2 * k + 1] += force.y * phi[at(k)];
      }
      rests_[at(i)] += dot(force, rest) - value * direction.*turn_;
    }
  }

  void addTo(Coupling& coupling) const {
    for (int i = 0; i < contact_.coefficients(); ++i) {
      const int k = contact_.functionOf(i);
      const Coefficients& own = contact_.of(i);
      const bool clamped = own.holdsNothing(k);
      addTo(clamped ? coupling.completion : coupling.trace, i, contact_.numberOf(i), 1);
      for (const std::size_t end : {0, 1})
        if (k == (end == 0 ? 0 : contact_.degree))
          for (const auto& [other, factor] : own.ends[end].added)
            addTo(coupling.completion, i, other, factor);
    }
  }

 private:
  /// Of a coefficient's work, as a part of that of another one.
  void addTo(TraceCoupling& trace, int i, Index number, double factor) const {
    trace.rests[at(number)] += factor * rests_[at(i)];
    for (int k = 0; 2 * k < traces_.rows(); ++k)
      for (const int c : {0, 1})
        trace.entries.push_back({space_.displacement(element_, k, c), number,
                                 factor * traces_(2 * Index{k} + c, i)});
  }

  const ContactElement& contact_;
  const bem::Space& space_;
  int element_;
  double Direction::*turn_;
  Matrix traces_;  ///< ∫ χ_i d·φ_k: components of displacement functions x coefficients
  Vector rests_;  ///< ∫ χ_i d·(r - r_I), less what turns of arcs do
};

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
  std::vector<Coupling> couplings(spaces.size());
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    couplings[b].opposite = &opposite;
    couplings[b].trace = couplings[b].completion = {
        {}, spaces[b]->rotation(), Vector(at(multiplier.size()))};
  }
  multiplier.forEachElement([&](const ContactElement& contact) {
    Works own(contact, *spaces[at(contact.body)], contact.element, &Direction::ownTurn);
    std::map<std::pair<int, int>, Works> facing;  // by body and element
    for (const Stretch& stretch : stretches(opposite, contact)) {
      const Opposite::Point middle = opposite.at(contact, stretch.middle);
      if (middle.element >= 0)
        checkEnds(contact, multiplier.basis());
      forEachPointOf(
          contact, multiplier.basis(), ruleOfForces(contact, middle),
          [&](const SidePoint& point) {
            own.add(point, point.weight, point.t);
            const int body = point.opposite.body;
            const int element = point.opposite.element;
            if (element >= 0)
              facing
                  .try_emplace({body, element}, contact, *spaces[at(body)], element,
                               &Direction::oppositeTurn)
                  .first->second.add(point, -point.weight, point.opposite.t);
          },
          stretch);
    }
    own.addTo(couplings[at(contact.body)]);
    for (const auto& [where, works] : facing)
      works.addTo(couplings[at(where.first)]);
  });
  return couplings;
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
