#include "bem/tpetra/SymmetricOperator.hpp"

#include <Teuchos_BLAS.hpp>

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
  const int n = static_cast<int>(x.getNumVectors());
  if (rows_.rows() > 0 && n > 0)
    Teuchos::BLAS<int, double>().GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS,
                                      asInt(rows_.rows()), n, asInt(rows_.columns()),
                                      alpha, rows_.data(), asInt(rows_.stride()),
                                      in.data(), static_cast<int>(in.stride(1)), beta,
                                      out.data(), static_cast<int>(out.stride(1)));
}

}  // namespace epafi::bem
