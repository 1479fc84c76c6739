#include "bem/algebra/SmallAlgebra.hpp"

#include "bem/base/BlasThreads.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::bem {

using Lapack = Teuchos::LAPACK<int, double>;

double dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void axpy(double s, const Vector& x, Vector& y) {
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += s * x[i];
}

Vector times(double s, Vector x) {
  for (double& entry : x)
    entry *= s;
  return x;
}

double largestEntry(const Vector& x) {
  double size = 0;
  for (const double entry : x) {
    if (std::isnan(entry))
      return entry;
    size = std::max(size, std::abs(entry));
  }
  return size;
}

Vector columnOf(const Matrix& a, Index j) {
  return {a.column(j), a.column(j) + a.rows()};
}

Svd singularValues(Matrix a) {
  const int m = asInt(a.rows());
  const int n = asInt(a.columns());
  const int k = std::min(m, n);
  Svd svd{Matrix(m, k), Vector(at(k)), Matrix(n, n)};
  if (k == 0) {
    for (Index i = 0; i < n; ++i)
      svd.vt(i, i) = 1;
    return svd;
  }
  Vector work(at(16 * (m + n)));
  int info = 0;
  Lapack().GESVD('S', 'A', m, n, a.data(), asInt(a.stride()), svd.s.data(), svd.u.data(),
                 asInt(svd.u.stride()), svd.vt.data(), asInt(svd.vt.stride()),
                 work.data(), static_cast<int>(work.size()), nullptr, &info);
  if (info != 0)
    throw NumericalError("the singular values of a small matrix do not converge");
  return svd;
}

int rank(const Svd& svd, double threshold) {
  return static_cast<int>(
      std::count_if(svd.s.begin(), svd.s.end(), [&](double s) { return s > threshold; }));
}

std::vector<Index> pivotedTriangle(Matrix& a) {
  const int n = asInt(a.columns());
  std::vector<int> pivots(a.columns());
  Vector tau(a.columns());
  Vector work(2 * n + 64 * (n + 1));
  int info = 0;
  const BlasThreads threads(blasThreadsFor(workOfProduct(a.rows(), n, n)));
  Lapack().GEQP3(asInt(a.rows()), n, a.data(), asInt(a.stride()), pivots.data(),
                 tau.data(), work.data(), static_cast<int>(work.size()), nullptr, &info);
  std::vector<Index> places;
  places.reserve(pivots.size());
  for (const int pivot : pivots)
    places.push_back(pivot - 1);
  return places;
}

int cholesky(Matrix& a) {
  int info = 0;
  const BlasThreads threads(
      blasThreadsFor(workOfProduct(a.rows(), a.rows(), a.rows() / 6)));
  if (a.rows() > 0)
    Lapack().POTRF('L', asInt(a.rows()), a.data(), asInt(a.stride()), &info);
  return info;
}

void choleskySolve(const Matrix& factor, MatrixView b) {
  int info = 0;
  const BlasThreads threads(
      blasThreadsFor(workOfProduct(factor.rows(), factor.rows(), b.columns())));
  if (!b.empty())
    Lapack().POTRS('L', asInt(factor.rows()), asInt(b.columns()), factor.data(),
                   asInt(factor.stride()), b.data(), asInt(b.stride()), &info);
}

}  // namespace epafi::bem
