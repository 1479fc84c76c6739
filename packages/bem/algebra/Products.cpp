#include "bem/algebra/Products.hpp"

#include "bem/base/BlasThreads.hpp"

#include <Teuchos_BLAS.hpp>

namespace epafi::bem {

namespace {

void add(Teuchos::ETransp op, double s, const Matrix& a, const Matrix& b, Matrix& c) {
  using Blas = Teuchos::BLAS<int, double>;
  const int lda = asInt(a.stride());
  if (c.empty() || b.rows() == 0)
    return;
  const double work = workOfProduct(c.rows(), b.rows(), c.columns());
  const BlasThreads threads(blasThreadsFor(work));  // where byColumns has one for all
  if (c.columns() == 1)
    return Blas().GEMV(op, asInt(a.rows()), asInt(a.columns()), s, a.data(), lda,
                       b.data(), 1, 1, c.data(), 1);
  byColumns(c.columns(), work, [&](Index first, Index count) {
    Blas().GEMM(op, Teuchos::NO_TRANS, asInt(c.rows()), asInt(count), asInt(b.rows()), s,
                a.data(), lda, b.column(first), asInt(b.stride()), 1, c.column(first),
                asInt(c.stride()));
  });
}

}  // namespace

void addProduct(double s, const Matrix& a, const Matrix& b, Matrix& c) {
  add(Teuchos::NO_TRANS, s, a, b, c);
}

void addTransposedProduct(double s, const Matrix& a, const Matrix& b, Matrix& c) {
  add(Teuchos::TRANS, s, a, b, c);
}

}  // namespace epafi::bem
