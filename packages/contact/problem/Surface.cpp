#include "contact/problem/Surface.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::at;

void addTimes(double factor, const std::vector<bem::Entry>& entries, const Vector& x,
              Vector& y) {
  for (const auto& [row, column, value] : entries)
    y[at(row)] += factor * value * x[at(column)];
}

Vector Surface::closing(const Vector& multiplier) const {
  Vector closing(multiplier.size(), 0.0);
  addTimes(1, linear, multiplier, closing);
  for (const auto& [i, length, law] : places)
    closing[at(i)] += length * law.closing(multiplier[at(i)]);
  return closing;
}

double Surface::energy(const Vector& multiplier) const {
  const auto stores = static_cast<std::ptrdiff_t>(linear.size() - wearing);
  Vector closing(multiplier.size(), 0.0);
  addTimes(0.5, {linear.begin(), linear.begin() + stores}, multiplier, closing);
  double energy = bem::dot(multiplier, closing);
  for (const auto& [i, length, law] : places)
    energy += length * law.energy(multiplier[at(i)]);
  return energy;
}

std::vector<bem::Entry> Surface::linearise(const Vector& multiplier, Vector& r,
                                           Vector& c) const {
  std::vector<bem::Entry> slopes = linear;
  for (const auto& [i, length, law] : places) {
    const double own = multiplier[at(i)];
    const double whole = r[at(i)] + length * law.closing(own);
    const double touching = law.resolvent(c[at(i)] * length, own + c[at(i)] * whole);
    r[at(i)] = whole;  // without φ where the contact is open
    if (!(touching > 0))
      continue;
    const double slope = length * law.slope(touching);
    r[at(i)] = (1 / c[at(i)] + slope) * (touching - own);
    c[at(i)] /= 1 + c[at(i)] * slope;
    slopes.push_back({i, i, slope});
  }
  return slopes;
}

}  // namespace epafi::contact
