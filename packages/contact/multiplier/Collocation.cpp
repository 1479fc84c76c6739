#include "contact/multiplier/Collocation.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

Collocation::Collocation(const MultiplierBasis& basis, Vector places)
    : places_(std::move(places)) {
  const auto n = static_cast<Index>(places_.size());
  values_ = bem::Matrix(n, n);
  for (Index i = 0; i < n; ++i) {
    const Vector row =
        basis.values(static_cast<int>(n) - 1, places_[static_cast<std::size_t>(i)]);
    for (Index j = 0; j < n; ++j)
      values_(i, j) = row[static_cast<std::size_t>(j)];
  }
}

Vector Collocation::coefficients(Vector values) const {
  bem::Matrix factor = values_.copy();
  const int n = static_cast<int>(places_.size());
  const int stride = static_cast<int>(factor.stride());
  const int one = 1;
  std::vector<int> pivots(places_.size());
  int info = 0;
  dgesv_(&n, &one, factor.data(), &stride, pivots.data(), values.data(), &n, &info);
  if (info != 0)
    throw bem::NumericalError("the multiplier's basis is linearly dependent");
  return values;
}

bem::Matrix Collocation::inverse() const {
  const auto n = static_cast<Index>(places_.size());
  bem::Matrix result(n, n);
  for (Index j = 0; j < n; ++j) {
    Vector unit(places_.size(), 0.0);
    unit[static_cast<std::size_t>(j)] = 1;
    unit = coefficients(std::move(unit));
    std::copy(unit.begin(), unit.end(), result.column(j));
  }
  return result;
}

}  // namespace epafi::contact
