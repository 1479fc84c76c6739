#include "bem/algebra/SmallAlgebra.hpp"

#include <Teuchos_LAPACK.hpp>

#include <numeric>

namespace epafi::bem {

double dot(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void axpy(double s, const Vector& x, Vector& y) {
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += s * x[i];
}

Vector columnOf(const Matrix& a, Index j) {
  return {a.column(j), a.column(j) + a.rows()};
}

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix product(a.rows(), b.columns());
  for (Index j = 0; j < b.columns(); ++j)
    for (Index k = 0; k < a.columns(); ++k)
      for (Index i = 0; i < a.rows(); ++i)
        product(i, j) += a(i, k) * b(k, j);
  return product;
}

Matrix transposedTimes(const Matrix& a, const Matrix& b) {
  Matrix product(a.columns(), b.columns());
  for (Index j = 0; j < b.columns(); ++j)
    for (Index i = 0; i < a.columns(); ++i)
      product(i, j) =
          std::inner_product(a.column(i), a.column(i) + a.rows(), b.column(j), 0.0);
  return product;
}

int cholesky(Matrix& a) {
  int info = 0;
  if (a.rows() > 0)
    Teuchos::LAPACK<int, double>().POTRF('L', static_cast<int>(a.rows()), a.data(),
                                         static_cast<int>(a.stride()), &info);
  return info;
}

void choleskySolve(const Matrix& factor, double* b) {
  int info = 0;
  const int size = static_cast<int>(factor.rows());
  if (size > 0)
    Teuchos::LAPACK<int, double>().POTRS(
        'L', size, 1, factor.data(), static_cast<int>(factor.stride()), b, size, &info);
}

}  // namespace epafi::bem
