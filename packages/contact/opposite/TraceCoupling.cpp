#include "contact/opposite/TraceCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

void dropRounding(const Vector& alongX, const Vector& alongY, const Vector& motion,
                  Vector& moved) {
  constexpr double rounding = 1e-13;
  const double size = bem::largestEntry(motion);
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (std::abs(moved[i]) <= rounding * size * std::hypot(alongX[i], alongY[i]))
      moved[i] = 0;
}

Vector TraceCoupling::apply(const Vector& u) const {
  Vector result(rests.size());
  addApplied(u.data(), result);
  return result;
}

void TraceCoupling::addApplied(const double* u, Vector& r) const {
  for (const bem::Entry& entry : entries)
    r[at(entry.column)] += entry.value * u[entry.row];
  if (rotation == nullptr)
    return;
  const Vector& q = rotation->functional();
  bem::axpy(std::inner_product(q.begin(), q.end(), u, 0.0), rests, r);
}

void TraceCoupling::addTranspose(double s, const double* multiplier,
                                 double* force) const {
  for (const bem::Entry& entry : entries)
    force[entry.row] += s * entry.value * multiplier[entry.column];
  if (rotation == nullptr)
    return;
  const double work = s * std::inner_product(rests.begin(), rests.end(), multiplier, 0.0);
  for (std::size_t j = 0; j < rotation->functional().size(); ++j)
    force[j] += work * rotation->functional()[j];
}

void TraceCoupling::addTo(Matrix& transposed) const {
  for (const bem::Entry& entry : entries)
    transposed(entry.row, entry.column) += entry.value;
  for (std::size_t i = 0; rotation != nullptr && i < rests.size(); ++i)
    if (rests[i] != 0)
      for (Index j = 0; j < transposed.rows(); ++j)
        transposed(j, static_cast<Index>(i)) += rests[i] * rotation->functional()[at(j)];
}

}  // namespace epafi::contact
