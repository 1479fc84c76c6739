#include "contact/body/Coupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/basis/Legendre.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// values of functions times a force, by components: two rows a function.
void addForce(Vec2 force, const double* values, double* rows, Index size) {
  for (Index k = 0; k < size; k += 2) {
    rows[k] += force.x * values[k / 2];
    rows[k + 1] += force.y * values[k / 2];
  }
}

/// What one contact element has of C, G and M, coefficients χ_i d: first those with the normal d,
/// then those with the tangent, which may turn.  G's rows: with Form Density Legendre polynomials,
/// the densities', where S u is evaluated orthonormal ones, else none.
class ElementCoupling {
 public:
  ElementCoupling(const bem::Space& space, const MultiplierBasis& basis,
                  const Stabilization& stabilization, const ContactElement& contact)
      : space_(space),
        basis_(basis),
        byDensity_(stabilization.byDensity()),
        byTractions_(stabilization.tractions().has_value()),
        contact_(contact),
        element_(space.mesh()[contact.element]),
        traces_(2 * (element_.degree + 1), size()),
        parts_(rows(), size()),
        mass_(size(), size()),
        rests_(at(size())) {
    integrate();
  }

  void addTo(double gamma, Index firstRow, Coupling& coupling) const {
    for (Index i = 0; i < size(); ++i) {
      const Index number = numberOf(i);
      const Coefficients::End* end = endOf(i);
      const bool clamped = end != nullptr && end->clamped;
      addTrace(i, number, 1, clamped ? coupling.completion : coupling.trace);
      if (end != nullptr)
        for (const auto& [other, factor] : end->added)
          addTrace(i, other, factor, coupling.completion);
      for (Index k = 0; k < size() && gamma != 0; ++k)
        if (mass_(i, k) != 0)
          coupling.mass.push_back({number, numberOf(k), gamma * mass_(i, k)});
      for (Index row = 0; row < rows() && gamma != 0; ++row)
        coupling.weights.push_back(
            {firstRow + row, number, gamma * normOf(row) * parts_(row, i)});
    }
  }

  /// A traction in λ's place.
  void addMoments(double gamma, Index firstRow, const BoundaryTraction& traction,
                  const std::vector<BoundaryTraction>& tested,
                  Loads::InResidual& moments) const {
    Vector parts(at(rows()));
    Matrix testedParts(rows(), static_cast<Index>(tested.size()));
    forEachPointOf(contact_, space_.mesh(), basis_, bem::gaussForGiven(element_.degree),
                   [&](const SidePoint& point) {
                     const auto legendre = orthonormal(point.t);
                     const double weight = stabilising(point);
                     const Vec2 force = weight * traction(contact_.element, point.t);
                     addForce(force, legendre.data(), parts.data(), rows());
                     for (std::size_t k = 0; k < tested.size(); ++k) {
                       const Vec2 r = tested[k](contact_.element, point.t);
                       addForce(weight * r, legendre.data(),
                                testedParts.column(static_cast<Index>(k)), rows());
                       if (isWhole())
                         moments.means[k] += gamma * dot(force, r);
                     }
                     for (Index i = 0; i < size() && isWhole(); ++i)
                       moments.terms[at(numberOf(i))] -=
                           gamma * point.chi[functionOf(i)] *
                           dot(force, directionOf(i, point));
                   });
    const auto timesParts = [&](const double* column) {
      return gamma * std::inner_product(parts.begin(), parts.end(), column, 0.0);
    };
    for (Index i = 0; i < size() && !isWhole(); ++i)
      moments.terms[at(numberOf(i))] -= timesParts(parts_.column(i));
    for (Index k = 0; k < testedParts.columns() && !isWhole(); ++k)
      moments.means[at(k)] += timesParts(testedParts.column(k));
    for (Index row = 0; row < rows(); ++row)
      moments.weights[at(firstRow + row)] = gamma * normOf(row) * parts[at(row)];
  }

 private:
  Index functions() const { return contact_.degree + 1; }
  Index size() const { return contact_.shears() ? 2 * functions() : functions(); }
  bool isTangential(Index i) const { return i >= functions(); }
  std::size_t functionOf(Index i) const { return at(i % functions()); }
  Index numberOf(Index i) const { return own(i).number(static_cast<int>(functionOf(i))); }
  Vec2 directionOf(Index i, const SidePoint& point) const {
    return isTangential(i) ? point.tangent : point.normal;
  }
  const Coefficients& own(Index i) const {
    return isTangential(i) ? contact_.tangential : contact_.normal;
  }
  /// Null inside the element.
  const Coefficients::End* endOf(Index i) const {
    return functionOf(i) == 0                     ? &own(i).ends[0]
           : functionOf(i) == at(contact_.degree) ? &own(i).ends[1]
                                                  : nullptr;
  }
  /// The rows of the element's tractions, or its densities.
  Index rows() const {
    return 2 * (byDensity_ ? element_.densities : byTractions_ ? element_.degree + 1 : 0);
  }

  /// The stabilisation weighs with the radius in the middle of the element: its residual is zero
  /// where the solution is exact, and G stays diagonal.
  double stabilising(const SidePoint& point) const {
    const bem::Mesh& mesh = space_.mesh();
    const int e = contact_.element;
    return point.weight * (mesh.measure(e, 0) / mesh.measure(e, point.t));
  }

  /// Legendre polynomials on the element, orthonormal, and what one of them is multiplied by to
  /// be that of G's row.
  std::array<double, bem::largestDegree + 2> orthonormal(double t) const {
    std::array<double, bem::largestDegree + 2> legendre{};
    const auto count = static_cast<int>(rows() / 2);
    bem::legendreValues(count - 1, t, legendre.data());
    for (int l = 0; l < count; ++l)
      legendre[l] *= std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element_.half));
    return legendre;
  }
  double normOf(Index row) const {
    const Index degree = row / 2;
    const auto l = static_cast<double>(degree);
    return byDensity_ ? std::sqrt(2 * element_.half / (2 * l + 1)) : 1;
  }

  /// Where S u is projected on polynomials, so is λ: on arcs they leave something of it, and M is
  /// the product of what they take.
  bool isWhole() const { return !byTractions_ || element_.curve.pointsOfTurning() == 0; }

  void integrate() {
    const int p = element_.degree;
    forEachPointOf(contact_, space_.mesh(), basis_,
                   bem::gaussLegendre(p + std::max(1, element_.curve.pointsOfTurning())),
                   [&](const SidePoint& point) { add(point); });
    if (!isWhole())
      mass_ = bem::transposedTimes(parts_, parts_);
  }

  void add(const SidePoint& point) {
    std::array<double, bem::largestDegree + 1> phi{};
    bem::DisplacementBasis::values(element_.degree, point.t, phi.data());
    const auto legendre = orthonormal(point.t);
    const Vec2 rest = space_.rotationRest(contact_.element, point.t);
    const double weight = stabilising(point);
    for (Index i = 0; i < size(); ++i) {
      const Vec2 force = point.weight * point.chi[functionOf(i)] * directionOf(i, point);
      const double value = weight * point.chi[functionOf(i)];
      addForce(force, phi.data(), traces_.column(i), traces_.rows());
      addForce(value * directionOf(i, point), legendre.data(), parts_.column(i), rows());
      rests_[at(i)] += dot(force, rest);
      for (Index k = 0; k < size(); ++k)
        if (isTangential(k) == isTangential(i))
          mass_(i, k) += value * point.chi[functionOf(k)];
    }
  }

  /// Of a coefficient's work, as a part of that of another one.
  void addTrace(Index i, Index number, double factor, TraceCoupling& trace) const {
    trace.rests[at(number)] += factor * rests_[at(i)];
    for (int k = 0; k <= element_.degree; ++k)
      for (const int c : {0, 1})
        trace.entries.push_back({space_.displacement(contact_.element, k, c), number,
                                 factor * traces_(2 * static_cast<Index>(k) + c, i)});
  }

  const bem::Space& space_;
  const MultiplierBasis& basis_;
  bool byDensity_;
  bool byTractions_;
  const ContactElement& contact_;
  const bem::Element& element_;
  Matrix traces_;  ///< ∫ χ_i d·φ_k: components of displacement functions x coefficients
  Matrix parts_;  ///< ∫ χ_i d·P_l, P_l orthonormal, likewise
  Matrix mass_;   ///< ∫ χ_i χ_k of one direction, or of their parts
  Vector rests_;  ///< ∫ χ_i d·(r - r_I)
};

}  // namespace

Coupling makeCoupling(const bem::Space& space, const MultiplierSpace& multiplier,
                      const Stabilization& stabilization, const bem::Lame& lame,
                      bem::Units units, std::vector<Index> start) {
  const Vector none(at(multiplier.size()));
  Coupling coupling;
  coupling.trace = {{}, space.rotation(), none};
  coupling.completion = coupling.trace;
  coupling.stabilization = stabilization;
  if (stabilization.isOn() && !multiplier.elements().empty())
    coupling.gamma0 = stabilization.firstGamma0();
  coupling.compliance = densityCompliance(space, multiplier, stabilization, lame, units);
  const bool ofDensities = start.empty();
  coupling.start = ofDensities ? std::vector<Index>{0} : std::move(start);
  for (const ContactElement& contact : multiplier.elements()) {
    const double gamma =
        gammaOn(space.mesh(), contact.element, stabilization, lame.nu, units);
    const Index first = coupling.start[coupling.gamma.size()];
    if (ofDensities)
      coupling.start.push_back(first + 2 * space.mesh()[contact.element].densities);
    coupling.gamma.push_back(gamma);
    ElementCoupling(space, multiplier.basis(), stabilization, contact)
        .addTo(gamma, first, coupling);
  }
  return coupling;
}

Loads::InResidual tractionMoments(const bem::Space& space,
                                  const MultiplierSpace& multiplier,
                                  const Coupling& coupling,
                                  const BoundaryTraction& traction,
                                  const std::vector<BoundaryTraction>& tested) {
  Loads::InResidual moments;
  moments.weights.assign(at(coupling.start.back()), 0.0);
  moments.terms.assign(at(multiplier.size()), 0.0);
  moments.means.assign(tested.size(), 0.0);
  for (std::size_t k = 0; k < multiplier.elements().size(); ++k)
    if (coupling.gamma[k] != 0)
      ElementCoupling(space, multiplier.basis(), coupling.stabilization,
                      multiplier.elements()[k])
          .addMoments(coupling.gamma[k], coupling.start[k], traction, tested, moments);
  return moments;
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
