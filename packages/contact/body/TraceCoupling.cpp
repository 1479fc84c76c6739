#include "contact/body/TraceCoupling.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

namespace epafi::contact {

Vector TraceCoupling::apply(const Vector& u) const {
  Vector result(rests.size());
  for (const bem::Entry& entry : entries)
    result[at(entry.column)] += entry.value * u[at(entry.row)];
  if (rotation != nullptr)
    bem::axpy(rotation->amount(u), rests, result);
  return result;
}

void TraceCoupling::addTranspose(const Vector& multiplier, Vector& force) const {
  for (const bem::Entry& entry : entries)
    force[at(entry.row)] += entry.value * multiplier[at(entry.column)];
  if (rotation != nullptr)
    rotation->complete(bem::dot(rests, multiplier), force);
}

}  // namespace epafi::contact
