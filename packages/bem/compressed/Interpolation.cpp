#include "bem/compressed/Interpolation.hpp"

#include "bem/algebra/Blas.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// R of A = Q R, which has the same column relations in fewer rows.
Matrix triangle(Matrix a) {
  const int m = static_cast<int>(a.rows());
  const int n = static_cast<int>(a.columns());
  const int lda = static_cast<int>(a.stride());
  constexpr int block = 32;
  const int nb = std::min(block, n);
  Matrix t(nb, n);
  Vector work(at(nb * n));
  const int ldt = static_cast<int>(t.stride());
  int info = 0;
  dgeqrt_(&m, &n, &nb, a.data(), &lda, t.data(), &ldt, work.data(), &info);
  Matrix r(n, n);
  for (Index j = 0; j < n; ++j)
    std::copy_n(a.column(j), j + 1, r.column(j));
  return r;
}

}  // namespace

Interpolation interpolateColumns(Matrix a, double threshold) {
  const Index columns = a.columns();
  if (a.rows() > columns)
    a = triangle(std::move(a));
  const int m = static_cast<int>(a.rows());
  const int n = static_cast<int>(columns);
  const int lda = static_cast<int>(a.stride());
  std::vector<int> pivots(at(n));
  Vector tau(at(n));
  Vector work(at(2 * n + 64 * (n + 1)));
  const int size = static_cast<int>(work.size());
  int info = 0;
  dgeqp3_(&m, &n, a.data(), &lda, pivots.data(), tau.data(), work.data(), &size, &info);
  const Index most = std::min<Index>(m, n);
  Index rank = 0;
  while (rank < most && std::abs(a(rank, rank)) >= threshold)
    ++rank;

  Interpolation result;
  Matrix rest(rank, columns - rank);
  for (Index j = 0; j < rest.columns(); ++j)
    std::copy_n(a.column(rank + j), rank, rest.column(j));
  if (!rest.empty()) {
    const int k = static_cast<int>(rank);
    const int others = static_cast<int>(rest.columns());
    const int ldb = static_cast<int>(rest.stride());
    const double one = 1;
    dtrsm_("L", "U", "N", "N", &k, &others, &one, a.data(), &lda, rest.data(), &ldb);
  }
  result.weights = Matrix(rank, columns);
  for (Index j = 0; j < columns; ++j) {
    const Index column = pivots[at(j)] - 1;
    if (j < rank) {
      result.skeleton.push_back(column);
      result.weights(j, column) = 1;
    } else {
      std::copy_n(rest.column(j - rank), rank, result.weights.column(column));
    }
  }
  return result;
}

}  // namespace epafi::bem
