#include "contact/multiplier/Collocation.hpp"

#include "bem/base/Error.hpp"

#include <utility>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

Collocation::Collocation(const MultiplierBasis& basis, Vector places)
    : places_(std::move(places)) {
  const auto n = static_cast<Index>(places_.size());
  values_ = bem::Matrix(n, n);
  for (Index i = 0; i < n; ++i) {
    const Vector row = basis.values(static_cast<int>(n) - 1, places_[i]);
    for (Index j = 0; j < n; ++j)
      values_(i, j) = row[j];
  }
  factor_ = bem::LuFactor(values_.copy());
  if (!factor_.isRegular())
    throw bem::NumericalError("the multiplier's basis is linearly dependent");
}

Vector Collocation::coefficients(Vector values) const {
  factor_.solve(values);
  return values;
}

bem::Matrix Collocation::inverse() const {
  bem::Matrix result(values_.rows(), values_.rows());
  for (Index i = 0; i < result.rows(); ++i)
    result(i, i) = 1;
  factor_.solve(result);
  return result;
}

}  // namespace epafi::contact
