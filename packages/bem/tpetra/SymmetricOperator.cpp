#include "bem/tpetra/SymmetricOperator.hpp"

#include "bem/algebra/Blas.hpp"

namespace epafi::bem {

SymmetricOperator::SymmetricOperator(const Matrix& lower, const TpetraAlgebra& algebra)
    : rows_(algebra.bothTriangles(lower)),
      map_(algebra.rowMap(lower.columns())),
      replicated_(algebra.replicatedMap(lower.columns())),
      import_(map_, replicated_) {}

void SymmetricOperator::apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp,
                              double alpha, double beta) const {
  MultiVector all(replicated_, x.getNumVectors());
  all.doImport(x, import_, Tpetra::INSERT);
  const auto in = all.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto out = y.getLocalViewHost(Tpetra::Access::ReadWrite);
  const int m = static_cast<int>(rows_.rows());
  const int n = static_cast<int>(x.getNumVectors());
  const int k = static_cast<int>(rows_.columns());
  const int lda = static_cast<int>(rows_.stride());
  const int ldb = static_cast<int>(in.stride(1));
  const int ldc = static_cast<int>(out.stride(1));
  if (m > 0 && n > 0)
    dgemm_("N", "N", &m, &n, &k, &alpha, rows_.data(), &lda, in.data(), &ldb, &beta,
           out.data(), &ldc);
}

}  // namespace epafi::bem
