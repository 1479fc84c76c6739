#include "contact/problem/Tangential.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

double at(const Vector& v, Index i) { return v[static_cast<std::size_t>(i)]; }

}  // namespace

double Tangential::sum(const Vector& pressures) const {
  double result = law->slipBound(std::max(at(pressures, normal), 0.0), strength);
  for (const NormalShare& other : others)
    result += law->slipBound(std::max(at(pressures, other.normal), 0.0), other.value);
  return result;
}

// The strength that decides alone; null where the sum does.
const double* Tangential::alone(const Vector& pressures) const {
  if (others.empty())
    return &strength;
  const double pressure = std::max(at(pressures, normal), 0.0);
  const double s = sum(pressures);
  if (s < law->slipBound(pressure, least))
    return &least;
  return s > law->slipBound(pressure, most) ? &most : nullptr;
}

double Tangential::bound(const Vector& pressures) const {
  const double* own = alone(pressures);
  return own == nullptr ? sum(pressures)
                        : law->slipBound(std::max(at(pressures, normal), 0.0), *own);
}

std::vector<NormalShare> Tangential::slopes(const Vector& pressures) const {
  std::vector<NormalShare> result;
  const auto add = [&](Index place, double share) {
    const double slope = law->slipBoundSlope(at(pressures, place), share);
    if (slope != 0)
      result.push_back({place, slope});
  };
  const double* own = alone(pressures);
  add(normal, own == nullptr ? strength : *own);
  if (own == nullptr)
    for (const NormalShare& other : others)
      add(other.normal, other.value);
  return result;
}

Tangential Tangential::uncoupled() const {
  double sum = strength;
  for (const NormalShare& other : others)
    sum += other.value;
  return {normal, law, others.empty() ? strength : std::clamp(sum, least, most)};
}

Tangential Tangential::scaled(double factor) const {
  Tangential result = *this;
  for (double* strengths : {&result.strength, &result.least, &result.most})
    *strengths *= factor;
  for (NormalShare& other : result.others)
    other.value *= factor;
  return result;
}

}  // namespace epafi::contact
