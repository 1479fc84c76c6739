#include "bem/compressed/ScaledLu.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

using Lapack = Teuchos::LAPACK<int, double>;

void scaleRows(const Vector& scales, Matrix& x) {
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      x(i, j) *= scales[i];
}

}  // namespace

ScaledLu::ScaledLu(Matrix matrix)
    : lu_(std::move(matrix)), scales_(lu_.rows()), pivots_(at(lu_.rows())) {
  const int n = asInt(lu_.rows());
  if (n == 0)
    return;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      scales_[i] = std::max(scales_[i], std::abs(lu_(i, j)));
  for (double& scale : scales_)
    scale = scale > 0 ? 1 / scale : 1;
  scaleRows(scales_, lu_);
  int info = 0;
  Lapack().GETRF(n, n, lu_.data(), asInt(lu_.stride()), pivots_.data(), &info);
  bool isRegular = info == 0;
  for (Index i = 0; i < n; ++i)  // what is not a number is no pivot either
    isRegular = isRegular && std::abs(lu_(i, i)) > 0;
  if (!isRegular)
    throw NumericalError("the compressed system is singular");
}

void ScaledLu::solve(Matrix& x) const {
  const int n = asInt(lu_.rows());
  if (n == 0)
    return;
  scaleRows(scales_, x);
  const double work = workOfProduct(n, n, x.columns());
  byColumns(x.columns(), work, [&](Index first, Index count) {
    int info = 0;
    Lapack().GETRS('N', n, asInt(count), lu_.data(), asInt(lu_.stride()), pivots_.data(),
                   x.column(first), asInt(x.stride()), &info);
  });
}

}  // namespace epafi::bem
