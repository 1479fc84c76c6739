#pragma once

#include "bem/tpetra/ColumnPanels.hpp"
#include "bem/tpetra/TpetraAlgebra.hpp"

namespace epafi::bem {

/// Cholesky's factor in panels of columns on all processes.
///
/// LAPACK's and BLAS' operations on the process's own panels and columns; what passes
/// between processes is one panel of L after the other.  [doc/decisions/0015]
class PanelFactor final : public CholeskyFactor {
 public:
  /// \throws NumericalError on all processes if the matrix is not positive definite.
  PanelFactor(ColumnPanels matrix, const TpetraAlgebra& algebra, const char* name);

  Vector solve(const Vector& b) const override;
  Matrix forward(Matrix rows) const override;
  Vector backward(const Vector& b) const override;

 private:
  void factorise(int k);
  void update(int j, int k, const PanelStream::View& panel);
  Vector forwardOnOwners(const Vector& b) const;

  ColumnPanels panels_;
  const TpetraAlgebra& algebra_;
};

}  // namespace epafi::bem
