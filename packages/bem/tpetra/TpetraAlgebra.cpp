#include "bem/tpetra/TpetraAlgebra.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/tpetra/PanelFactor.hpp"
#include "bem/tpetra/Redeal.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <vector>

namespace epafi::bem {

namespace {

using Blas = Teuchos::BLAS<int, double>;
using Teuchos::LOWER_TRI;
using Teuchos::NO_TRANS;
using Teuchos::RCP;
using Teuchos::rcp;
using Teuchos::TRANS;

/// The communicator inside, or that of this process alone for a serial one.
MPI_Comm mpiOf(const Teuchos::Comm<int>& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (mpi == nullptr)
    return MPI_COMM_SELF;
  return *mpi->getRawMpiComm();
}

/// Rows of one process, from `offset` on among its own.
struct Panel {
  int owner;
  Index offset;
  Rows rows;
};

/// All n rows in panels of at most `width`, the processes taking turns.
std::vector<Panel> panelsOf(int processes, Index n, Index width) {
  std::vector<Panel> panels;
  const Index height = shareOf(0, processes, n).size();
  for (Index offset = 0; offset < height; offset += width)
    for (int owner = 0; owner < processes; ++owner) {
      const Rows all = shareOf(owner, processes, n);
      const Rows rows{std::min(all.begin + offset, all.end),
                      std::min(all.begin + offset + width, all.end)};
      if (rows.size() > 0)
        panels.push_back({owner, offset, rows});
    }
  return panels;
}

}  // namespace

TpetraAlgebra::TpetraAlgebra(RCP<const Teuchos::Comm<int>> comm,
                             Consent::LastResort lastResort)
    : comm_(std::move(comm)),
      mpi_(mpiOf(*comm_)),
      rank_(comm_->getRank()),
      processes_(comm_->getSize()),
      consent_(std::make_unique<Consent>(mpi_, std::move(lastResort))) {}

Rows TpetraAlgebra::rowsOf(int rank, Index n) const {
  return shareOf(rank, processes_, n);
}

Rows TpetraAlgebra::myRows(Index n) const { return rowsOf(rank_, n); }

RCP<const Tpetra::Map<>> TpetraAlgebra::rowMap(Index n) const {
  return rcp(new Tpetra::Map<>(n, static_cast<std::size_t>(myRows(n).size()), 0, comm_));
}

RCP<const Tpetra::Map<>> TpetraAlgebra::replicatedMap(Index n) const {
  return rcp(new Tpetra::Map<>(n, 0, comm_, Tpetra::LocallyReplicated));
}

std::unique_ptr<CholeskyFactor> TpetraAlgebra::cholesky(Matrix lower,
                                                        const char* name) const {
  if (processes_ == 1)
    return alone_.cholesky(std::move(lower), name);
  ColumnPanels panels(mpi_, lower.columns());
  consent_->confirm();
  panels.take(lower);
  lower = Matrix();
  return std::make_unique<PanelFactor>(std::move(panels), *this, name);
}

/// rows + my rows of Σ T_r over the processes r, where product(panel, t) puts the panel's
/// rows of this process's T into t: all columns, or those up to the panel's last one.
template <class Product>
Matrix TpetraAlgebra::collect(Matrix rows, Index n, Part part,
                              const Product& product) const {
  constexpr Index width = 1024;  // BLAS copies the other factor once for each panel
  const Index height = std::min(width, rowsOf(0, n).size());
  Vector sums(static_cast<std::size_t>(height * rows.columns()));
  consent_->confirm();
  for (const auto& [owner, offset, panel] : panelsOf(processes_, n, width)) {
    const Index columns = part == Part::Lower ? panel.end : rows.columns();
    if (columns == 0)
      continue;
    product(panel, sums.data());
    const bool mine = owner == rank_;
    MPI_Reduce(mine ? MPI_IN_PLACE : sums.data(), mine ? sums.data() : nullptr,
               asInt(panel.size() * columns), MPI_DOUBLE, MPI_SUM, owner, mpi_);
    if (!mine)
      continue;
    const double* sum = sums.data();
    for (Index j = 0; j < columns; ++j)
      for (Index i = 0; i < panel.size(); ++i)
        rows(offset + i, j) += *sum++;
  }
  return rows;
}

Matrix TpetraAlgebra::addGram(Matrix lower, const Matrix& y) const {
  if (processes_ == 1)
    return alone_.addGram(std::move(lower), y);
  const Index n = lower.columns();
  return collect(std::move(lower), n, Part::Lower, [&](const Rows& panel, double* t) {
    const int height = asInt(panel.size());
    const int depth = asInt(y.rows());
    const int ld = asInt(y.stride());
    Blas().GEMM(TRANS, NO_TRANS, height, asInt(panel.begin), depth, 1,
                y.column(panel.begin), ld, y.data(), ld, 0, t, height);
    Blas().SYRK(LOWER_TRI, TRANS, height, depth, 1, y.column(panel.begin), ld, 0,
                t + height * panel.begin, height);
  });
}

Matrix TpetraAlgebra::addOuter(Matrix lower, const Matrix& x, double scale) const {
  if (processes_ == 1)
    return alone_.addOuter(std::move(lower), x, scale);
  const Index n = lower.columns();
  const Matrix mine = byColumns(x, n);
  return collect(std::move(lower), n, Part::Lower, [&](const Rows& panel, double* t) {
    const int height = asInt(panel.size());
    const int depth = asInt(mine.columns());
    const int ld = asInt(mine.stride());
    Blas().GEMM(NO_TRANS, TRANS, height, asInt(panel.begin), depth, scale,
                mine.data() + panel.begin, ld, mine.data(), ld, 0, t, height);
    Blas().SYRK(LOWER_TRI, NO_TRANS, height, depth, scale, mine.data() + panel.begin, ld,
                0, t + height * panel.begin, height);
  });
}

Matrix TpetraAlgebra::addTransposeTimes(Matrix c, const Matrix& x,
                                        const Matrix& y) const {
  if (processes_ == 1)
    return alone_.addTransposeTimes(std::move(c), x, y);
  return collect(
      std::move(c), x.columns(), Part::Whole, [&](const Rows& panel, double* t) {
        Blas().GEMM(TRANS, NO_TRANS, asInt(panel.size()), asInt(y.columns()),
                    asInt(x.rows()), 1, x.column(panel.begin), asInt(x.stride()),
                    y.data(), asInt(y.stride()), 0, t, asInt(panel.size()));
      });
}

/// From my rows of all columns to all rows of my columns.
Matrix TpetraAlgebra::byColumns(const Matrix& rows, Index n) const {
  Redeal redeal(mpi_, n, rows.columns());
  Matrix columns(n, redeal.columns());
  consent_->confirm();
  return redeal.toColumns(rows, std::move(columns));
}

Matrix TpetraAlgebra::bothTriangles(const Matrix& lower) const {
  const Index n = lower.columns();
  const Rows mine = myRows(n);
  Matrix rows = lower.copy();
  const Matrix mirrored = processes_ == 1 ? lower.copy() : byColumns(lower, n);
  for (Index j = mine.begin + 1; j < n; ++j)
    for (Index i = 0; i < std::min(mine.size(), j - mine.begin); ++i)
      rows(i, j) = mirrored(j, i);
  return rows;
}

Vector TpetraAlgebra::multiply(const Matrix& a, Index n, const Vector& x) const {
  Vector mine = alone_.multiply(a, a.rows(), x);
  if (processes_ == 1)
    return mine;
  Vector y(static_cast<std::size_t>(n));
  consent_->confirm();
  std::vector<int> counts;
  std::vector<int> starts;
  for (int r = 0; r < processes_; ++r) {
    counts.push_back(asInt(rowsOf(r, n).size()));
    starts.push_back(asInt(rowsOf(r, n).begin));
  }
  MPI_Allgatherv(mine.data(), asInt(a.rows()), MPI_DOUBLE, y.data(), counts.data(),
                 starts.data(), MPI_DOUBLE, mpi_);
  return y;
}

Vector TpetraAlgebra::multiplySymmetric(const Matrix& lower, const Vector& x) const {
  if (processes_ == 1)
    return alone_.multiplySymmetric(lower, x);
  const Rows mine = myRows(lower.columns());
  const int height = asInt(mine.size());
  const int width = asInt(mine.begin);
  const int ld = asInt(lower.stride());
  const int step = 1;
  const double one = 1;
  Vector y(x.size());
  double* const own = y.data() + mine.begin;
  if (height > 0) {  // the block on the diagonal, then what is left of it, used twice
    dsymv_("L", &height, &one, lower.column(mine.begin), &ld, x.data() + mine.begin,
           &step, &one, own, &step);
    Blas().GEMV(NO_TRANS, height, width, 1, lower.data(), ld, x.data(), 1, 1, own, 1);
    Blas().GEMV(TRANS, height, width, 1, lower.data(), ld, x.data() + mine.begin, 1, 1,
                y.data(), 1);
  }
  return sum(std::move(y));
}

Matrix TpetraAlgebra::replicate(Matrix rows, Index n) const {
  if (processes_ == 1)
    return rows;
  const Index m = rows.columns();
  const Index height = rowsOf(0, n).size();
  Matrix whole(n, m);
  Vector block(static_cast<std::size_t>(height * m));
  consent_->confirm();
  for (int owner = 0; owner < processes_; ++owner) {
    const Rows theirs = rowsOf(owner, n);
    if (owner == rank_)
      for (Index j = 0; j < m; ++j)
        std::copy_n(rows.column(j), theirs.size(), block.data() + j * theirs.size());
    MPI_Bcast(block.data(), asInt(theirs.size() * m), MPI_DOUBLE, owner, mpi_);
    for (Index j = 0; j < m; ++j)
      std::copy_n(block.data() + j * theirs.size(), theirs.size(),
                  whole.column(j) + theirs.begin);
  }
  return whole;
}

// Reduced on one process and sent out, so that all have the same bits.
Vector TpetraAlgebra::sum(Vector mine) const {
  if (processes_ == 1)
    return mine;
  Vector total(mine.size());
  consent_->confirm();
  const int n = asInt(static_cast<Index>(mine.size()));
  MPI_Reduce(mine.data(), total.data(), n, MPI_DOUBLE, MPI_SUM, 0, mpi_);
  MPI_Bcast(total.data(), n, MPI_DOUBLE, 0, mpi_);
  return total;
}

Vector TpetraAlgebra::broadcast(Vector root) const {
  if (processes_ == 1)
    return root;
  consent_->confirm();
  auto size = static_cast<long>(root.size());
  MPI_Bcast(&size, 1, MPI_LONG, 0, mpi_);
  root.resize(static_cast<std::size_t>(size));
  MPI_Bcast(root.data(), static_cast<int>(size), MPI_DOUBLE, 0, mpi_);
  return root;
}

}  // namespace epafi::bem
