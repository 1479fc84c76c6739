#include "bem/algebra/LuFactor.hpp"

#include "bem/base/BlasThreads.hpp"
#include "bem/base/Parallel.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

using Lapack = Teuchos::LAPACK<int, double>;

/// Of A X, or of a factorisation with as many columns.
int threadsOf(const Matrix& a, Index columns) {
  return blasThreadsFor(workOfProduct(a.rows(), a.rows(), columns));
}

}  // namespace

LuFactor::LuFactor(Matrix a) : lu_(std::move(a)), pivots_(at(lu_.columns())) {
  for (Index j = 0; j < lu_.columns(); ++j) {
    double sum = 0;
    for (Index i = 0; i < lu_.rows(); ++i)
      sum += std::abs(lu_(i, j));
    norm_ = std::max(norm_, sum);
  }
  int info = 0;
  const BlasThreads threads(threadsOf(lu_, lu_.rows() / 3));
  if (!lu_.empty())
    Lapack().GETRF(asInt(lu_.rows()), asInt(lu_.rows()), lu_.data(), asInt(lu_.stride()),
                   pivots_.data(), &info);
  isRegular_ = info == 0;
}

double LuFactor::reciprocalCondition() const {
  if (lu_.empty() || !isRegular_)
    return isRegular_ ? 1 : 0;
  Vector work(4 * pivots_.size());
  std::vector<int> integers(pivots_.size());
  double reciprocal = 0;
  int info = 0;
  const BlasThreads threads(threadsOf(lu_, 1));
  Lapack().GECON('1', asInt(lu_.rows()), lu_.data(), asInt(lu_.stride()), norm_,
                 &reciprocal, work.data(), integers.data(), &info);
  return info == 0 ? reciprocal : 0;
}

void LuFactor::solve(double* x, Index columns, Index stride) const {
  int info = 0;
  const BlasThreads threads(threadsOf(lu_, columns));
  if (!lu_.empty() && columns > 0)
    Lapack().GETRS('N', asInt(lu_.rows()), asInt(columns), lu_.data(),
                   asInt(lu_.stride()), pivots_.data(), x, asInt(stride), &info);
}

}  // namespace epafi::bem
