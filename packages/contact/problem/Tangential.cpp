#include "contact/problem/Tangential.hpp"

#include "contact/multiplier/BoundCoefficients.hpp"
#include "contact/multiplier/Collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double positive(const Vector& v, Index i) {
  return std::max(v[static_cast<std::size_t>(i)], 0.0);
}

// One law after another's field values: least and most of each, all combinations.
std::vector<PointLaw> extremes(const std::vector<PressureBound>& fields,
                               const std::shared_ptr<const FrictionLaw>& law,
                               double stress) {
  std::vector<Vector> corners = {{}};
  for (const PressureBound& field : fields) {
    const std::size_t known = corners.size();
    for (std::size_t k = 0; k < known; ++k) {
      if (field.least != field.most) {
        corners.push_back(corners[k]);
        corners.back().push_back(field.least);
      }
      corners[k].push_back(field.most);
    }
  }
  std::vector<PointLaw> result;
  result.reserve(corners.size());
  for (Vector& values : corners)
    result.emplace_back(law, std::move(values), stress);
  return result;
}

std::vector<PointLaw> lawsAt(const std::vector<PressureBound>& fields,
                             Vector PressureBound::*values,
                             const std::shared_ptr<const FrictionLaw>& law,
                             std::size_t count, double stress) {
  std::vector<PointLaw> result;
  for (std::size_t i = 0; i < count; ++i) {
    Vector here;
    for (const PressureBound& field : fields)
      here.push_back((field.*values)[i]);
    result.emplace_back(law, std::move(here), stress);
  }
  return result;
}

}  // namespace

// s = T λ⁺ + what a law that is not proportional to the pressure adds.  The part of a
// proportional one is a fixed T for all λ, so that its rounding is no noise.
StepBound Tangential::linear(const Vector& pressures) const {
  const ElementLaw& element = *element_;
  const auto n = static_cast<Index>(element.nodes.size());
  StepBound result;
  Vector shares(static_cast<std::size_t>(n), 0.0);  // T_ij
  double steepest = 0;
  for (Index k = 0; k < n; ++k) {
    const double share = element.inverse(place_, k);
    double pressure = 0;
    for (Index j = 0; j < n; ++j)
      pressure += element.values(k, j) *
                  positive(pressures, element.normals[static_cast<std::size_t>(j)]);
    const PointLaw& law = element.nodes[static_cast<std::size_t>(k)];
    const double slope = law.slope(pressure);
    const double bound = law.bound(pressure);
    const double rest = bound - slope * pressure;
    if (std::abs(rest) > 8 * epsilon * bound)
      result.value += share * rest;
    steepest = std::max(steepest, std::abs(slope));
    for (std::size_t j = 0; j < shares.size(); ++j)
      shares[j] += share * slope * element.values(k, static_cast<Index>(j));
  }
  for (std::size_t j = 0; j < shares.size(); ++j) {
    const Index normal = element.normals[j];
    const double pressure = positive(pressures, normal);
    // The ends' control points are values there: what else their rows have is rounding.
    const bool isRounding =
        normal != normal_ && std::abs(shares[j]) <= 64 * epsilon * steepest;
    if (pressure > 0 && shares[j] != 0 && !isRounding) {
      result.value += shares[j] * pressure;
      result.slopes.push_back({normal, shares[j]});
    }
  }
  return result;
}

double Tangential::bound(const Vector& pressures) const {
  if (isTied())
    return std::numeric_limits<double>::infinity();
  const double own = positive(pressures, normal_);
  if (element_ == nullptr)
    return factor_ * law_.bound(own);
  const double s = linear(pressures).value;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const PointLaw& law : element_->extremes) {
    least = std::min(least, law.bound(own));
    most = std::max(most, law.bound(own));
  }
  return factor_ * std::clamp(s, least, most);
}

std::vector<NormalShare> Tangential::slopes(const Vector& pressures) const {
  if (isTied())
    return {};
  const double own = positive(pressures, normal_);
  StepBound result;
  if (element_ == nullptr) {
    result.slopes = {{normal_, law_.slope(own)}};
  } else {
    result = linear(pressures);
    const auto& laws = element_->extremes;
    const auto [least, most] = std::minmax_element(
        laws.begin(), laws.end(), [own](const PointLaw& a, const PointLaw& b) {
          return a.bound(own) < b.bound(own);
        });
    if (result.value < least->bound(own))
      result.slopes = {{normal_, least->slope(own)}};
    else if (result.value > most->bound(own))
      result.slopes = {{normal_, most->slope(own)}};
  }
  for (NormalShare& share : result.slopes)
    share.value *= factor_;
  auto& slopes = result.slopes;
  slopes.erase(std::remove_if(slopes.begin(), slopes.end(),
                              [](const NormalShare& share) { return share.value == 0; }),
               slopes.end());
  return slopes;
}

template <class Of>
double Tangential::largest(const Of& of) const {
  double result = element_ == nullptr ? of(law_) : 0;
  if (element_ != nullptr)
    for (const PointLaw& law : element_->extremes)
      result = std::max(result, of(law));
  return factor_ * result;
}

bool Tangential::followsPressure() const {
  return element_ != nullptr || law_.followsPressure();
}

bool Tangential::carries() const {
  return isTied() || largest([](const PointLaw& law) { return law.bound(1); }) > 0;
}

double Tangential::steepest() const {
  return largest([](const PointLaw& law) { return law.steepest(); });
}

double Tangential::boundWithoutPressure() const {
  if (isTied())
    return std::numeric_limits<double>::infinity();
  return largest([](const PointLaw& law) { return law.bound(0); });
}

Tangential Tangential::shifted(Index normals) const {
  Tangential result = *this;
  if (isTied())
    return result;
  result.normal_ += normals;
  if (element_) {
    std::vector<Index> shifted = element_->normals;
    for (Index& normal : shifted)
      normal += normals;
    result.element_ = std::make_shared<const ElementLaw>(
        ElementLaw{std::move(shifted), element_->nodes, element_->values.copy(),
                   element_->inverse.copy(), element_->extremes});
  }
  return result;
}

Tangential Tangential::scaled(double factor) const {
  Tangential result = *this;
  result.factor_ *= factor;
  return result;
}

std::vector<Tangential> elementTangentials(const MultiplierBasis& basis,
                                           const std::vector<Index>& normals,
                                           const std::shared_ptr<const FrictionLaw>& law,
                                           const std::function<Vector(double)>& fields,
                                           double stress) {
  const int degree = static_cast<int>(normals.size()) - 1;
  std::vector<Tangential> result;
  if (!law->dependsOnPressure()) {
    const Vector bounds = boundCoefficients(
        basis, degree, [&](double t) { return law->bound(0, fields(t)) / stress; });
    for (std::size_t i = 0; i < normals.size(); ++i)
      result.emplace_back(normals[i], PointLaw(bounds[i]));
    return result;
  }
  std::vector<PressureBound> bounds;
  const std::size_t count = fields(0).size();
  for (std::size_t f = 0; f < count; ++f)
    bounds.push_back(
        pressureBound(basis, degree, [&](double t) { return fields(t)[f]; }));
  if (!isCoupled(bounds)) {
    std::vector<PointLaw> laws =
        lawsAt(bounds, &PressureBound::alone, law, normals.size(), stress);
    for (std::size_t i = 0; i < normals.size(); ++i)
      result.emplace_back(normals[i], std::move(laws[i]));
    return result;
  }
  const Collocation nodes(basis, bounds.front().nodes);
  const auto element = std::make_shared<const ElementLaw>(ElementLaw{
      normals, lawsAt(bounds, &PressureBound::atNodes, law, normals.size(), stress),
      nodes.values(), nodes.inverse(), extremes(bounds, law, stress)});
  for (Index i = 0; i <= degree; ++i)
    result.emplace_back(element, i);
  return result;
}

}  // namespace epafi::contact
