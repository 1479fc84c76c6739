#pragma once

#include "bem/tpetra/MpiProcesses.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

#include <functional>

namespace epafi::bem {

/// A linear map of replicated vectors as a Tpetra::Operator on distributed vectors, for example
/// for Belos.  Compressed operators:
///
///   WholeVectorOperator z(n, [&](const Matrix& x) { return operators.times(x); }, processes);
///
/// CompressedFactor::solve gives the inverse, or with a coarse tolerance a preconditioner.
class WholeVectorOperator : public Tpetra::Operator<> {
 public:
  using MultiVector = Tpetra::MultiVector<>;
  /// All rows of A X from all rows of X (columns).  Collective.
  using Action = std::function<Matrix(const Matrix& x)>;

  /// Collective.  \param n rows and columns of A.  Refers to the processes.
  WholeVectorOperator(Index n, Action action, const MpiProcesses& processes);

  Teuchos::RCP<const Tpetra::Map<>> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Tpetra::Map<>> getRangeMap() const override { return map_; }

  /// y = alpha A x + beta y; for beta = 0 the old y is ignored.
  /// \throws std::logic_error if mode is not NO_TRANS
  void apply(const MultiVector& x, MultiVector& y,
             Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;

  /// All rows of a distributed X.  Collective.
  Matrix whole(const MultiVector& x) const;

 private:
  Action action_;
  Teuchos::RCP<const Tpetra::Map<>> map_;
  Teuchos::RCP<const Tpetra::Map<>> replicated_;
  Tpetra::Import<> import_;
};

}  // namespace epafi::bem
