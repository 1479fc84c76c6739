#include "contact/results/Resolution.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::contact {

bool Resolution::isResolved() const {
  constexpr double most = 0.3;
  return error.normal <= most * std::abs(mean);
}

Resolution resolutionOf(const ContactFields& fields,
                        const ContactFields::Element& element) {
  const int p = element.degree;
  const bem::Rule& rule = bem::gaussLegendre(p + 1);
  std::array<double, bem::largestDegree + 1> values{};
  std::array<MultiplierSpace::Value, bem::largestDegree + 1> coefficients{};
  for (int q = 0; q < rule.size(); ++q) {
    const auto stress = fields.stress(element, rule.points[q]);
    bem::legendreValues(p, rule.points[q], values.data());
    for (int k = 0; k <= p; ++k) {
      const double weight = (k + 0.5) * rule.weights[q] * values[k];
      coefficients[k].normal += weight * stress.normal;
      coefficients[k].tangential += weight * stress.tangential;
    }
  }
  Resolution result{{}, coefficients[0].normal};
  for (int k = std::max(1, p - 1); k <= p; ++k) {
    result.error.normal += std::abs(coefficients[k].normal);
    result.error.tangential += std::abs(coefficients[k].tangential);
  }
  return result;
}

void PeakPressure::add(const ContactFields& fields, const Vector& pressures,
                       const ContactFields::Element& element, bool insideSide) {
  const Resolution resolution = resolutionOf(fields, element);
  Vector places = bem::gaussLegendre(element.degree + 1).points;
  places.insert(places.end(), {-1.0, 1.0});
  Largest& largest = resolution.isResolved() ? resolved_ : unresolved_;
  for (const double t : places)
    largest.add({fields.inUnits(pressures, element, t).normal, resolution.error.normal});
  if (resolution.isResolved())
    return;
  unresolvedMean_ = std::max(unresolvedMean_, resolution.mean);
  if (!insideSide)
    atEnds_ = std::max(atEnds_, resolution.mean);
}

void PeakPressure::add(const PeakPressure& other) {
  resolved_.add(other.resolved_);
  unresolved_.add(other.unresolved_);
  unresolvedMean_ = std::max(unresolvedMean_, other.unresolvedMean_);
  atEnds_ = std::max(atEnds_, other.atEnds_);
}

}  // namespace epafi::contact
