#include "bem/algebra/LeastSquares.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/BlasThreads.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

// A P = Q R, R x = Qᵀ b in the leading rows
SeveralLeastSquares leastSquares(Matrix a, Matrix b, double dependent) {
  const int m = asInt(a.rows());
  const int n = asInt(a.columns());
  const int k = std::min(m, n);
  SeveralLeastSquares result{Matrix(n, b.columns()), 0, Vector(at(b.columns()))};
  std::vector<int> pivots(at(n));
  Vector tau(at(n));
  Vector work(at(2 * n + 64 * (std::max<Index>(n, b.columns()) + 1)));
  const auto size = static_cast<int>(work.size());
  int info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  const BlasThreads one(1);
  if (k > 0) {
    lapack.GEQP3(m, n, a.data(), asInt(a.stride()), pivots.data(), tau.data(),
                 work.data(), size, nullptr, &info);
    lapack.ORMQR('L', 'T', m, asInt(b.columns()), k, a.data(), asInt(a.stride()),
                 tau.data(), b.data(), asInt(b.stride()), work.data(), size, &info);
  }
  while (result.rank < k &&
         std::abs(a(result.rank, result.rank)) > dependent * std::abs(a(0, 0)))
    ++result.rank;
  for (Index c = 0; c < b.columns(); ++c) {
    for (Index i = result.rank; i < m; ++i)
      result.rests[at(c)] = std::hypot(result.rests[at(c)], b(i, c));
    for (Index j = result.rank; j-- > 0;) {
      const double x = b(j, c) / a(j, j);
      for (Index i = 0; i < j; ++i)
        b(i, c) -= x * a(i, j);
      result.x(pivots[at(j)] - 1, c) = x;
    }
  }
  return result;
}

LeastSquares leastSquares(const std::vector<Vector>& columns, Vector b,
                          double dependent) {
  Matrix a(static_cast<Index>(b.size()), static_cast<Index>(columns.size()));
  for (Index j = 0; j < a.columns(); ++j)
    std::copy(columns[at(j)].begin(), columns[at(j)].end(), a.column(j));
  const SeveralLeastSquares all =
      leastSquares(std::move(a), ConstMatrixView(b).copy(), dependent);
  return {columnOf(all.x, 0), all.rank, all.rests.front()};
}

}  // namespace epafi::bem
