#pragma once

#include "bem/tpetra/MpiProcesses.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

#include <functional>

namespace epafi::bem {

/// What acts on whole vectors as a Tpetra::Operator, for Belos and for whoever has distributed
/// vectors: the product of compressed operators,
///
///   WholeVectorOperator z(n, [&](const Matrix& x) { return operators.times(x); }, processes);
///
/// or with a CompressedFactor's solve() its inverse, of a coarse tolerance a preconditioner.
class WholeVectorOperator : public Tpetra::Operator<> {
 public:
  using MultiVector = Tpetra::MultiVector<>;
  /// All rows of A X from all rows of X (columns).  Collective.
  using Action = std::function<Matrix(const Matrix& x)>;

  /// Collective.  Of an n x n matrix; the processes outlive it.
  WholeVectorOperator(Index n, Action action, const MpiProcesses& processes);

  Teuchos::RCP<const Tpetra::Map<>> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Tpetra::Map<>> getRangeMap() const override { return map_; }

  /// y = alpha A x + beta y; whatever y holds, if beta = 0.  A alone:
  /// \throws std::logic_error if its transpose is asked for.
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
