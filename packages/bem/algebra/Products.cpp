#include "bem/algebra/Products.hpp"

#include "bem/base/BlasThreads.hpp"

#include <Teuchos_BLAS.hpp>

namespace epafi::bem {

namespace {

/// C <- s op(A) B + keep C
void multiply(Teuchos::ETransp op, double s, ConstMatrixView a, ConstMatrixView b,
              double keep, MatrixView c) {
  using Blas = Teuchos::BLAS<int, double>;
  const int lda = asInt(a.stride());
  if (c.empty() || b.rows() == 0)
    return;
  const double work = workOfProduct(c.rows(), b.rows(), c.columns());
  const BlasThreads threads(blasThreadsFor(work));  // where byColumns has one for all
  if (c.columns() == 1)
    return Blas().GEMV(op, asInt(a.rows()), asInt(a.columns()), s, a.data(), lda,
                       b.data(), 1, keep, c.data(), 1);
  byColumns(c.columns(), work, [&](Index first, Index count) {
    Blas().GEMM(op, Teuchos::NO_TRANS, asInt(c.rows()), asInt(count), asInt(b.rows()), s,
                a.data(), lda, b.column(first), asInt(b.stride()), keep, c.column(first),
                asInt(c.stride()));
  });
}

Matrix productOf(Teuchos::ETransp op, Index rows, ConstMatrixView a, ConstMatrixView b) {
  if (b.rows() == 0)
    return {rows, b.columns()};
  Matrix c = Matrix::unset(rows, b.columns());
  multiply(op, 1, a, b, 0, c);
  return c;
}

}  // namespace

void addProduct(double s, ConstMatrixView a, ConstMatrixView b, MatrixView c) {
  multiply(Teuchos::NO_TRANS, s, a, b, 1, c);
}

void addTransposedProduct(double s, ConstMatrixView a, ConstMatrixView b, MatrixView c) {
  multiply(Teuchos::TRANS, s, a, b, 1, c);
}

Matrix product(ConstMatrixView a, ConstMatrixView b) {
  return productOf(Teuchos::NO_TRANS, a.rows(), a, b);
}

Matrix transposedProduct(ConstMatrixView a, ConstMatrixView b) {
  return productOf(Teuchos::TRANS, a.columns(), a, b);
}

Vector product(ConstMatrixView a, const Vector& x) {
  Vector y(at(a.rows()));
  multiply(Teuchos::NO_TRANS, 1, a, ConstMatrixView(x), 0, MatrixView(y));
  return y;
}

Vector transposedProduct(ConstMatrixView a, const Vector& x) {
  Vector y(at(a.columns()));
  multiply(Teuchos::TRANS, 1, a, ConstMatrixView(x), 0, MatrixView(y));
  return y;
}

}  // namespace epafi::bem
