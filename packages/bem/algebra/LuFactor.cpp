#include "bem/algebra/LuFactor.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/BlasThreads.hpp"
#include "bem/base/Error.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::bem {

namespace {

using Lapack = Teuchos::LAPACK<int, double>;

void scaleRows(const Vector& scales, MatrixView x) {
  for (Index j = 0; j < x.columns(); ++j)
    for (std::size_t i = 0; i < scales.size(); ++i)
      x(static_cast<Index>(i), j) *= scales[i];
}

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
  for (Index i = 0; i < lu_.rows(); ++i)
    isRegular_ = isRegular_ && std::abs(lu_(i, i)) > 0;
}

LuFactor LuFactor::ofScaledRows(Matrix a, const char* name) {
  Vector scales(at(a.rows()));
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      scales[at(i)] = std::max(scales[at(i)], std::abs(a(i, j)));
  for (double& scale : scales)
    scale = scale > 0 ? 1 / scale : 1;
  scaleRows(scales, a);
  LuFactor factor(std::move(a));
  factor.scales_ = std::move(scales);
  if (!factor.isRegular())
    throw NumericalError(name, " is singular");
  return factor;
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

void LuFactor::solve(MatrixView x) const {
  assert(isRegular() && x.rows() == lu_.rows());
  if (lu_.empty())
    return;
  scaleRows(scales_, x);
  // where byColumns has one for all
  const BlasThreads threads(threadsOf(lu_, x.columns()));
  byColumns(x.columns(), workOfProduct(lu_.rows(), lu_.rows(), x.columns()),
            [&](Index first, Index count) {
              int info = 0;
              Lapack().GETRS('N', asInt(lu_.rows()), asInt(count), lu_.data(),
                             asInt(lu_.stride()), pivots_.data(), x.column(first),
                             asInt(x.stride()), &info);
            });
}

}  // namespace epafi::bem
