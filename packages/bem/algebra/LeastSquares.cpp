#include "bem/algebra/LeastSquares.hpp"

#include "bem/base/BlasThreads.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::bem {

// A P = Q R, R x = Qᵀ b in the leading rows
LeastSquares leastSquares(const std::vector<Vector>& columns, Vector b,
                          double dependent) {
  const int m = asInt(static_cast<Index>(b.size()));
  const int n = asInt(static_cast<Index>(columns.size()));
  const int k = std::min(m, n);
  LeastSquares result{Vector(columns.size())};
  Matrix a(m, n);
  for (int j = 0; j < n; ++j)
    std::copy(columns[at(j)].begin(), columns[at(j)].end(), a.column(j));
  std::vector<int> pivots(columns.size());
  Vector tau(columns.size());
  Vector work(2 * columns.size() + 64 * (columns.size() + 1));
  const auto size = static_cast<int>(work.size());
  int info = 0;
  const Teuchos::LAPACK<int, double> lapack;
  const BlasThreads one(1);
  if (k > 0) {
    lapack.GEQP3(m, n, a.data(), asInt(a.stride()), pivots.data(), tau.data(),
                 work.data(), size, nullptr, &info);
    lapack.ORMQR('L', 'T', m, 1, k, a.data(), asInt(a.stride()), tau.data(), b.data(), m,
                 work.data(), size, &info);
  }
  while (result.rank < k &&
         std::abs(a(result.rank, result.rank)) > dependent * std::abs(a(0, 0)))
    ++result.rank;
  for (Index i = result.rank; i < m; ++i)
    result.rest = std::hypot(result.rest, b[at(i)]);
  for (Index j = result.rank; j-- > 0;) {
    const double x = b[at(j)] / a(j, j);
    for (Index i = 0; i < j; ++i)
      b[at(i)] -= x * a(i, j);
    result.x[at(pivots[at(j)] - 1)] = x;
  }
  return result;
}

}  // namespace epafi::bem
