#include "bem/compressed/Interpolation.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/compressed/Products.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
  Vector work(nb * n);
  const int ldt = static_cast<int>(t.stride());
  int info = 0;
  dgeqrt_(&m, &n, &nb, a.data(), &lda, t.data(), &ldt, work.data(), &info);
  Matrix r(n, n);
  for (Index j = 0; j < n; ++j)
    std::copy_n(a.column(j), j + 1, r.column(j));
  return r;
}

}  // namespace

Matrix Interpolation::times(const Matrix& x) const {
  Matrix y = rowsOf(x, skeleton);
  addProduct(1, weights, rowsOf(x, rest), y);
  return y;
}

void Interpolation::addTransposed(const Matrix& x, Matrix& y) const {
  Matrix parts(weights.columns(), x.columns());
  addTransposedProduct(1, weights, x, parts);
  for (Index j = 0; j < x.columns(); ++j) {
    for (std::size_t i = 0; i < skeleton.size(); ++i)
      y(skeleton[i], j) += x(static_cast<Index>(i), j);
    for (std::size_t i = 0; i < rest.size(); ++i)
      y(rest[i], j) += parts(static_cast<Index>(i), j);
  }
}

Matrix Interpolation::full() const { return bem::transposed(transposed()); }

Matrix Interpolation::transposed() const {
  Matrix result(columns(), rows());
  for (Index j = 0; j < rows(); ++j) {
    result(skeleton[j], j) = 1;
    for (std::size_t i = 0; i < rest.size(); ++i)
      result(rest[i], j) = weights(j, static_cast<Index>(i));
  }
  return result;
}

Interpolation interpolateColumns(Matrix a, double threshold) {
  const Index columns = a.columns();
  if (a.rows() > columns)
    a = triangle(std::move(a));
  const int m = static_cast<int>(a.rows());
  const int n = static_cast<int>(columns);
  const int lda = static_cast<int>(a.stride());
  std::vector<int> pivots(n);
  Vector tau(n);
  Vector work(2 * n + 64 * (n + 1));
  const int size = static_cast<int>(work.size());
  int info = 0;
  dgeqp3_(&m, &n, a.data(), &lda, pivots.data(), tau.data(), work.data(), &size, &info);
  const Index most = std::min<Index>(m, n);
  Index rank = 0;
  while (rank < most && !(std::abs(a(rank, rank)) < threshold))  // NaN: ScaledLu throws
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
  for (Index j = 0; j < rank; ++j)
    result.skeleton.push_back(pivots[j] - 1);
  std::vector<std::pair<Index, Index>> places;  // of the rest, and where it stands
  for (Index j = rank; j < columns; ++j)
    places.emplace_back(pivots[j] - 1, j - rank);
  std::sort(places.begin(), places.end());
  result.weights = Matrix(rank, columns - rank);
  for (std::size_t j = 0; j < places.size(); ++j) {
    result.rest.push_back(places[j].first);
    std::copy_n(rest.column(places[j].second), rank,
                result.weights.column(static_cast<Index>(j)));
  }
  return result;
}

}  // namespace epafi::bem
