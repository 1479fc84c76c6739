#include "bem/compressed/Interpolation.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Parallel.hpp"

#include <Teuchos_BLAS.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::bem {

namespace {

/// R of A = Q R, which has the same column relations in fewer rows.
Matrix triangle(Matrix a) {
  const int m = asInt(a.rows());
  const int n = asInt(a.columns());
  const int lda = asInt(a.stride());
  constexpr int block = 32;
  const int nb = std::min(block, n);
  Matrix t(nb, n);
  Vector work(nb * n);
  const int ldt = asInt(t.stride());
  int info = 0;
  dgeqrt_(&m, &n, &nb, a.data(), &lda, t.data(), &ldt, work.data(), &info);
  Matrix r(n, n);
  for (Index j = 0; j < n; ++j)
    std::copy_n(a.column(j), j + 1, r.column(j));
  return r;
}

}  // namespace

Matrix Interpolation::times(const Matrix& x) const {
  Matrix y = Matrix::unset(rows(), x.columns());
  for (Index j = 0; j < x.columns(); ++j)
    for (std::size_t i = 0; i < skeleton.size(); ++i)
      y(static_cast<Index>(i), j) = skeleton[i] < 0 ? 0 : x(skeleton[i], j);
  addProduct(1, weights, rowsOf(x, rest), y);
  return y;
}

void Interpolation::addTransposed(const Matrix& x, Matrix& y) const {
  const Matrix parts = transposedProduct(weights, x);
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

Interpolation Interpolation::on(const std::vector<Index>& columns,
                                std::vector<Index>& rows) const {
  std::vector<Index> places(at(this->columns()), -1);  // of columns among those
  for (std::size_t k = 0; k < columns.size(); ++k)
    places[at(columns[k])] = static_cast<Index>(k);
  Interpolation result;
  std::vector<Index> kept;  // of the rest
  for (std::size_t j = 0; j < rest.size(); ++j)
    if (places[at(rest[j])] >= 0) {
      kept.push_back(static_cast<Index>(j));
      result.rest.push_back(places[at(rest[j])]);
    }
  rows.clear();
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    const Index place = places[at(skeleton[i])];
    if (place >= 0 || std::any_of(kept.begin(), kept.end(), [&](Index j) {
          return weights(static_cast<Index>(i), j) != 0;
        })) {
      rows.push_back(static_cast<Index>(i));
      result.skeleton.push_back(place);
    }
  }
  result.weights = Matrix::unset(result.rows(), static_cast<Index>(kept.size()));
  for (std::size_t j = 0; j < kept.size(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.weights(static_cast<Index>(i), static_cast<Index>(j)) =
          weights(rows[i], kept[j]);
  return result;
}

double ClusterPart::sweepWork(Index columns) const {
  const auto n = static_cast<Index>(active.size());
  return workOfProduct(n, n, columns);
}

Interpolation interpolateColumns(Matrix a, double threshold) {
  const Index columns = a.columns();
  if (a.rows() > columns)
    a = triangle(std::move(a));
  const std::vector<Index> pivots = pivotedTriangle(a);
  const Index most = std::min(a.rows(), columns);
  Index rank = 0;
  while (rank < most && !(std::abs(a(rank, rank)) < threshold))  // NaN: LuFactor throws
    ++rank;

  Interpolation result;
  Matrix rest = Matrix::unset(rank, columns - rank);
  for (Index j = 0; j < rest.columns(); ++j)
    std::copy_n(a.column(rank + j), rank, rest.column(j));
  if (!rest.empty())
    Teuchos::BLAS<int, double>().TRSM(
        Teuchos::LEFT_SIDE, Teuchos::UPPER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG,
        asInt(rank), asInt(rest.columns()), 1, a.data(), asInt(a.stride()), rest.data(),
        asInt(rest.stride()));
  result.skeleton.assign(pivots.begin(), pivots.begin() + rank);
  std::vector<std::pair<Index, Index>> places;  // of the rest, and where it stands
  for (Index j = rank; j < columns; ++j)
    places.emplace_back(pivots[j], j - rank);
  std::sort(places.begin(), places.end());
  result.weights = Matrix::unset(rank, columns - rank);
  for (std::size_t j = 0; j < places.size(); ++j) {
    result.rest.push_back(places[j].first);
    std::copy_n(rest.column(places[j].second), rank,
                result.weights.column(static_cast<Index>(j)));
  }
  return result;
}

}  // namespace epafi::bem
