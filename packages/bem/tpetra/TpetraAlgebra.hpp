#pragma once

#include "bem/algebra/LapackAlgebra.hpp"
#include "bem/tpetra/Consent.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_Map.hpp>

#include <memory>

namespace epafi::bem {

/// DenseAlgebra on the processes of a communicator.
///
/// Rows are dealt out in blocks of ceil(n/P), the last processes may have none.
/// Factorisations are made in panels of columns dealt out cyclically, triangular solves
/// on columns of the right-hand side, see PanelFactor; products are sums of each
/// process's own, collected panel by panel by the process that has the rows.  One process
/// uses LAPACK only.
///
/// Every call begins by asking for the others' consent, so a process that fails on its
/// own ends all of them: see Consent.
class TpetraAlgebra final : public DenseAlgebra {
 public:
  /// Collective.
  explicit TpetraAlgebra(Teuchos::RCP<const Teuchos::Comm<int>> comm,
                         Consent::LastResort lastResort = nullptr);

  Rows myRows(Index n) const override;
  std::unique_ptr<CholeskyFactor> cholesky(Matrix lower, const char* name) const override;
  Matrix addGram(Matrix lower, const Matrix& y) const override;
  Matrix addOuter(Matrix lower, const Matrix& x, double scale) const override;
  Matrix addTransposeTimes(Matrix c, const Matrix& x, const Matrix& y) const override;
  Vector multiply(const Matrix& a, Index n, const Vector& x) const override;
  Vector multiplySymmetric(const Matrix& lower, const Vector& x) const override;
  Matrix replicate(Matrix rows, Index n) const override;
  Vector sum(Vector mine) const override;
  Vector broadcast(Vector root) const override;
  int rank() const override { return rank_; }
  int processes() const override { return processes_; }

  /// My rows of a symmetric matrix, both triangles.
  Matrix bothTriangles(const Matrix& lower) const;

  const Consent& consent() const { return *consent_; }

  /// The distribution of n rows, and n replicated entries.
  Teuchos::RCP<const Tpetra::Map<>> rowMap(Index n) const;
  Teuchos::RCP<const Tpetra::Map<>> replicatedMap(Index n) const;

 private:
  enum class Part { Lower, Whole };

  Rows rowsOf(int rank, Index n) const;
  Matrix byColumns(const Matrix& rows, Index n) const;
  template <class Product>
  Matrix collect(Matrix rows, Index n, Part part, const Product& product) const;

  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  MPI_Comm mpi_ = MPI_COMM_SELF;
  int rank_ = 0;
  int processes_ = 1;
  LapackAlgebra alone_;
  std::unique_ptr<Consent> consent_;
};

}  // namespace epafi::bem
