#include "contact/compressed/CompressedCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <numeric>

namespace epafi::contact {

void CompressedCoupling::add(const TraceCoupling& trace, std::size_t body, Index start,
                             const Numbers& numberOf) {
  for (const bem::Entry& entry : trace.entries)
    entries.push_back({start + entry.row, numberOf(entry.column), entry.value});
  if (trace.rotation == nullptr)
    return;
  rests.push_back({trace.rotation, body, start, Vector(at(multipliers))});
  for (std::size_t i = 0; i < trace.rests.size(); ++i)
    rests.back().values[at(numberOf(static_cast<Index>(i)))] = trace.rests[i];
}

void CompressedCoupling::addOwn(const bem::Space& space, const Coupling& coupling,
                                std::size_t body, Index start, const Numbers& numberOf) {
  add(coupling.trace, body, start, numberOf);
  for (const bem::Entry& entry : coupling.weights)
    entries.push_back(
        {start + space.displacements() + coupling.compliance.densities[at(entry.row)],
         numberOf(entry.column), -entry.value});
  for (const bem::Entry& entry : coupling.mass)
    mass.push_back({numberOf(entry.row), numberOf(entry.column), entry.value});
}

void CompressedCoupling::addTranspose(double s, const double* multiplier,
                                      double* x) const {
  for (const bem::Entry& entry : entries)
    x[entry.row] += s * entry.value * multiplier[entry.column];
  for (const Rest& rest : rests) {
    const Vector& q = rest.rotation->functional();
    const double work =
        s * std::inner_product(rest.values.begin(), rest.values.end(), multiplier, 0.0);
    for (std::size_t j = 0; j < q.size(); ++j)
      x[rest.first + static_cast<Index>(j)] += work * q[j];
  }
}

Vector CompressedCoupling::apply(const double* x) const {
  Vector result(at(multipliers));
  for (const bem::Entry& entry : entries)
    result[at(entry.column)] += entry.value * x[entry.row];
  for (const Rest& rest : rests) {
    const Vector& q = rest.rotation->functional();
    bem::axpy(std::inner_product(q.begin(), q.end(), x + rest.first, 0.0), rest.values,
              result);
  }
  return result;
}

}  // namespace epafi::contact
