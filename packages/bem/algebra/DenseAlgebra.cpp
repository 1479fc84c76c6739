#include "bem/algebra/DenseAlgebra.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/BlasThreads.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <cstring>

namespace epafi::bem {

namespace {

using Blas = Teuchos::BLAS<int, double>;
using Lapack = Teuchos::LAPACK<int, double>;
using Teuchos::LOWER_TRI;
using Teuchos::NO_TRANS;
using Teuchos::TRANS;

double size(Index n) { return static_cast<double>(n); }

/// As many threads of BLAS as so many operations pay for, while it lives.
struct ThreadsForFlops : BlasThreads {
  explicit ThreadsForFlops(double flops)
      : BlasThreads(blasThreadsFor(workOfFlops(flops))) {}
};

/// The lower triangle in rectangular full packed form, in its own memory, and the rest of
/// that given back.  With k columns of length `height`, column j has the triangle's
/// column j from its diagonal on, at `shift` rows further down, and above it row j of
/// what the last columns hold.                                        [LAPACK, dtrttf,
/// TRANSR = N, UPLO = L]
Matrix pack(Matrix lower) {
  const Index n = lower.rows();
  const Index shift = n % 2 == 0 ? 1 : 0;
  const Index height = n + shift;
  const Index k = (n + 1) / 2;
  // column by column never ahead of what is still to be read: height <= stride + 1
  double* packed = lower.data();
  for (Index j = 0; j < k; ++j) {
    double* column = packed + j * height;
    std::memmove(column + j + shift, lower.column(j) + j,
                 static_cast<std::size_t>(n - j) * sizeof(double));
    const Index row = k + j - (1 - shift);
    for (Index i = 0; i < j + shift; ++i)
      column[i] = lower(row, k + i);
  }
  lower.shrink((height * k + lower.stride() - 1) / lower.stride());
  return lower;
}

/// L in the lower triangle.
Matrix factorised(Matrix lower, const char* name) {
  if (const int row = cholesky(lower); row != 0)
    throw NumericalError(name, " is not positive definite: Cholesky's factorisation ",
                         "breaks down in row ", row, " of ", lower.rows());
  return lower;
}

}  // namespace

CholeskyFactor::CholeskyFactor(Matrix lower, const char* name)
    : rows_(asInt(lower.rows())), packed_(pack(factorised(std::move(lower), name))) {}

Vector CholeskyFactor::solve(const Vector& b) const {
  Vector x = b;
  const int one = 1;
  int info = 0;
  const ThreadsForFlops threads(2 * size(rows_) * size(rows_));
  if (rows_ > 0)
    dpftrs_("N", "L", &rows_, &one, packed_.data(), x.data(), &rows_, &info);
  return x;
}

Matrix CholeskyFactor::forward(Matrix b) const {
  triangularSolve("N", asInt(b.columns()), b.data(), asInt(b.stride()));
  return b;
}

Vector CholeskyFactor::backward(const Vector& b) const {
  Vector x = b;
  triangularSolve("T", 1, x.data(), rows_);
  return x;
}

Matrix CholeskyFactor::inverseOfLast(Index count) const {
  Matrix inverse(count, count);
  const Index first = rows_ - count;
  for (Index j = 0; j < count; ++j)
    for (Index i = j; i < count; ++i)
      inverse(i, j) = entry(first + i, first + j);
  int info = 0;
  const ThreadsForFlops threads(size(count) * size(count) * size(count) / 3);
  if (count > 0)
    Lapack().TRTRI('L', 'N', asInt(count), inverse.data(), asInt(inverse.stride()),
                   &info);
  return inverse;
}

/// L_ij for i >= j, see pack.
double CholeskyFactor::entry(Index i, Index j) const {
  const Index shift = rows_ % 2 == 0 ? 1 : 0;
  const Index height = rows_ + shift;
  const Index k = (rows_ + 1) / 2;
  if (j < k)
    return packed_.data()[j * height + i + shift];
  return packed_.data()[(i - k + 1 - shift) * height + j - k];
}

void CholeskyFactor::triangularSolve(const char* transposed, int columns, double* b,
                                     int ld) const {
  const double one = 1;
  const ThreadsForFlops threads(size(rows_) * size(rows_) * size(columns));
  if (rows_ > 0 && columns > 0)
    dtfsm_("N", "L", "L", transposed, "N", &rows_, &columns, &one, packed_.data(), b,
           &ld);
}

Matrix addGram(Matrix c, const Matrix& y) {
  const ThreadsForFlops threads(size(c.rows()) * size(c.rows()) * size(y.rows()));
  if (!y.empty())
    Blas().SYRK(LOWER_TRI, TRANS, asInt(c.rows()), asInt(y.rows()), 1, y.data(),
                asInt(y.stride()), 1, c.data(), asInt(c.stride()));
  return c;
}

Matrix addOuter(Matrix c, const Matrix& x, double scale) {
  const ThreadsForFlops threads(size(c.rows()) * size(c.rows()) * size(x.columns()));
  if (!x.empty())
    Blas().SYRK(LOWER_TRI, NO_TRANS, asInt(c.rows()), asInt(x.columns()), scale, x.data(),
                asInt(x.stride()), 1, c.data(), asInt(c.stride()));
  return c;
}

Vector multiplySymmetric(const Matrix& lower, const Vector& x) {
  Vector y(x.size());
  const int n = asInt(lower.rows());
  const int ld = asInt(lower.stride());
  const int step = 1;
  const double one = 1;
  const double zero = 0;
  const ThreadsForFlops threads(2 * size(n) * size(n));
  if (n > 0)
    dsymv_("L", &n, &one, lower.data(), &ld, x.data(), &step, &zero, y.data(), &step);
  return y;
}

}  // namespace epafi::bem
