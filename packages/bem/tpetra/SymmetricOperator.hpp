#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tpetra/TpetraAlgebra.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

namespace epafi::bem {

/// A dense symmetric matrix as a Tpetra::Operator, on the row map of its algebra.
///
/// Keeps whole rows, so that any number of vectors costs one exchange of their entries
/// and one product of BLAS on each process.
class SymmetricOperator : public Tpetra::Operator<> {
 public:
  using MultiVector = Tpetra::MultiVector<>;

  /// Collective.  `lower`: the lower triangle, my rows.
  SymmetricOperator(const Matrix& lower, const TpetraAlgebra& algebra);

  Teuchos::RCP<const Tpetra::Map<>> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Tpetra::Map<>> getRangeMap() const override { return map_; }
  bool hasTransposeApply() const override { return true; }

  /// y = alpha A x + beta y; whatever y holds, if beta = 0.
  void apply(const MultiVector& x, MultiVector& y,
             Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;

  /// My rows, both triangles.
  const Matrix& rows() const { return rows_; }

 private:
  Matrix rows_;
  Teuchos::RCP<const Tpetra::Map<>> map_;
  Teuchos::RCP<const Tpetra::Map<>> replicated_;
  Tpetra::Import<> import_;
};

/// S: from displacements to the forces that belong to them, dimensionless.
class SteklovPoincareOperator final : public SymmetricOperator {
 public:
  SteklovPoincareOperator(const SteklovPoincare& operators, const TpetraAlgebra& algebra)
      : SymmetricOperator(operators.stiffness().unpacked(), algebra) {}
};

}  // namespace epafi::bem
