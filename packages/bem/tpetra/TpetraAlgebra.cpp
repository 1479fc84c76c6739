#include "bem/tpetra/TpetraAlgebra.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "bem/tpetra/BlockCyclic.hpp"
#include "bem/tpetra/Scalapack.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>

namespace epafi::bem {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;

constexpr int first = 1;  // ScaLAPACK counts from 1

int asInt(Index n) { return static_cast<int>(n); }

/// The communicator inside, or that of this process alone for a serial one.
MPI_Comm mpiOf(const Teuchos::Comm<int>& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (mpi == nullptr)
    return MPI_COMM_SELF;
  return *mpi->getRawMpiComm();
}

class CyclicFactor final : public CholeskyFactor {
 public:
  CyclicFactor(BlockCyclic factor, const Layouts& layouts, const TpetraAlgebra& algebra)
      : factor_(std::move(factor)), layouts_(layouts), algebra_(algebra) {}

  Vector solve(const Vector& b) const override {
    BlockCyclic x(layouts_, factor_.rows(), 1);
    algebra_.consent().confirm();
    x.takeColumn(b);
    const int n = factor_.rows();
    int info = 0;
    if (n > 0)
      pdpotrs_("L", &n, &first, factor_.data(), &first, &first, factor_.descriptor(),
               x.data(), &first, &first, x.descriptor(), &info);
    return algebra_.sum(x.giveColumn());
  }

  Matrix forward(Matrix rows) const override {
    BlockCyclic x(layouts_, factor_.rows(), rows.columns());
    algebra_.consent().confirm();
    x.takeRows(rows);
    triangularSolve("N", x);
    x.giveRows(rows);
    return rows;
  }

  Vector backward(const Vector& b) const override {
    BlockCyclic x(layouts_, factor_.rows(), 1);
    algebra_.consent().confirm();
    x.takeColumn(b);
    triangularSolve("T", x);
    return algebra_.sum(x.giveColumn());
  }

 private:
  void triangularSolve(const char* transposed, BlockCyclic& x) const {
    const int n = x.rows();
    const int m = x.columns();
    const double one = 1;
    if (n > 0 && m > 0)
      pdtrsm_("L", "L", transposed, "N", &n, &m, &one, factor_.data(), &first, &first,
              factor_.descriptor(), x.data(), &first, &first, x.descriptor());
  }

  BlockCyclic factor_;
  const Layouts& layouts_;
  const TpetraAlgebra& algebra_;
};

}  // namespace

TpetraAlgebra::TpetraAlgebra(RCP<const Teuchos::Comm<int>> comm,
                             Consent::LastResort lastResort)
    : comm_(std::move(comm)),
      mpi_(mpiOf(*comm_)),
      rank_(comm_->getRank()),
      processes_(comm_->getSize()),
      consent_(std::make_unique<Consent>(mpi_, std::move(lastResort))) {
  if (processes_ > 1)
    layouts_ = std::make_unique<Layouts>(mpi_);
}

TpetraAlgebra::~TpetraAlgebra() = default;

Rows TpetraAlgebra::rowsOf(int rank, Index n) const {
  const Index height = (n + processes_ - 1) / processes_;
  return {std::min(n, rank * height), std::min(n, (rank + 1) * height)};
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
  const int n = asInt(lower.columns());
  BlockCyclic factor(*layouts_, n, n);
  consent_->confirm();
  factor.takeRows(lower);
  lower = Matrix();
  int mine = 0;
  if (n > 0)
    pdpotrf_("L", &n, factor.data(), &first, &first, factor.descriptor(), &mine);
  int info = 0;
  MPI_Allreduce(&mine, &info, 1, MPI_INT, MPI_MAX, mpi_);
  if (info != 0)
    throw NumericalError(message(name,
                                 " is not positive definite: Cholesky's factorisation ",
                                 "breaks down in row ", info, " of ", n));
  return std::make_unique<CyclicFactor>(std::move(factor), *layouts_, *this);
}

/// rows + my rows of Σ T_r over the processes r, where product(panel, columns, t) puts
/// the panel's rows of this process's T, up to `columns`, into t.
template <class Product>
Matrix TpetraAlgebra::collect(Matrix rows, Index n, Part part,
                              const Product& product) const {
  constexpr Index width = 256;
  const Index panelSize = std::min(width, n) * rows.columns();
  Vector partial(static_cast<std::size_t>(panelSize));
  Vector total(static_cast<std::size_t>(panelSize));
  consent_->confirm();
  const Index height = rowsOf(0, n).size();
  for (Index offset = 0; offset < height; offset += width)
    for (int owner = 0; owner < processes_; ++owner) {
      const Rows all = rowsOf(owner, n);
      const Rows panel{std::min(all.begin + offset, all.end),
                       std::min(all.begin + offset + width, all.end)};
      const Index columns = part == Part::Lower ? panel.end : rows.columns();
      if (panel.size() == 0 || columns == 0)
        continue;
      product(panel, columns, partial.data());
      MPI_Reduce(partial.data(), total.data(), asInt(panel.size() * columns), MPI_DOUBLE,
                 MPI_SUM, owner, mpi_);
      if (owner != rank_)
        continue;
      for (Index j = 0; j < columns; ++j)
        for (Index i = 0; i < panel.size(); ++i)
          rows(offset + i, j) += total[static_cast<std::size_t>(i + j * panel.size())];
    }
  return rows;
}

Matrix TpetraAlgebra::addGram(Matrix lower, const Matrix& y) const {
  if (processes_ == 1)
    return alone_.addGram(std::move(lower), y);
  const Index n = lower.columns();
  return collect(std::move(lower), n, Part::Lower,
                 [&](const Rows& panel, Index columns, double* t) {
                   const int height = asInt(panel.size());
                   const int width = asInt(columns);
                   const int depth = asInt(y.rows());
                   const int ld = asInt(y.stride());
                   const double one = 1;
                   const double zero = 0;
                   dgemm_("T", "N", &height, &width, &depth, &one, y.column(panel.begin),
                          &ld, y.data(), &ld, &zero, t, &height);
                 });
}

Matrix TpetraAlgebra::addOuter(Matrix lower, const Matrix& x, double scale) const {
  if (processes_ == 1)
    return alone_.addOuter(std::move(lower), x, scale);
  const Index n = lower.columns();
  const Matrix mine = byColumns(x, n);
  return collect(
      std::move(lower), n, Part::Lower, [&](const Rows& panel, Index columns, double* t) {
        const int height = asInt(panel.size());
        const int width = asInt(columns);
        const int depth = asInt(mine.columns());
        const int ld = asInt(mine.stride());
        const double zero = 0;
        dgemm_("N", "T", &height, &width, &depth, &scale, mine.data() + panel.begin, &ld,
               mine.data(), &ld, &zero, t, &height);
      });
}

Matrix TpetraAlgebra::transposeTimes(const Matrix& x, const Matrix& y) const {
  if (processes_ == 1)
    return alone_.transposeTimes(x, y);
  const Index n = x.columns();
  return collect(Matrix(myRows(n).size(), y.columns()), n, Part::Whole,
                 [&](const Rows& panel, Index columns, double* t) {
                   const int height = asInt(panel.size());
                   const int width = asInt(columns);
                   const int depth = asInt(x.rows());
                   const int ldx = asInt(x.stride());
                   const int ldy = asInt(y.stride());
                   const double one = 1;
                   const double zero = 0;
                   dgemm_("T", "N", &height, &width, &depth, &one, x.column(panel.begin),
                          &ldx, y.data(), &ldy, &zero, t, &height);
                 });
}

/// From my rows of all columns to all rows of my columns.
Matrix TpetraAlgebra::byColumns(const Matrix& rows, Index n) const {
  const Index m = rows.columns();
  const Rows mine = myRows(n);
  const Rows myColumns = rowsOf(rank_, m);
  Vector sent(static_cast<std::size_t>(mine.size() * m));
  Vector received(static_cast<std::size_t>(n * myColumns.size()));
  Matrix result(n, myColumns.size());
  consent_->confirm();
  for (Index j = 0; j < m; ++j)
    std::copy_n(rows.column(j), mine.size(), sent.data() + j * mine.size());
  std::vector<int> sendCounts;
  std::vector<int> sendStarts;
  std::vector<int> receiveCounts;
  std::vector<int> receiveStarts;
  for (int r = 0; r < processes_; ++r) {
    const Rows theirColumns = rowsOf(r, m);
    const Rows theirRows = rowsOf(r, n);
    sendCounts.push_back(asInt(theirColumns.size() * mine.size()));
    sendStarts.push_back(asInt(theirColumns.begin * mine.size()));
    receiveCounts.push_back(asInt(theirRows.size() * myColumns.size()));
    receiveStarts.push_back(asInt(theirRows.begin * myColumns.size()));
  }
  MPI_Alltoallv(sent.data(), sendCounts.data(), sendStarts.data(), MPI_DOUBLE,
                received.data(), receiveCounts.data(), receiveStarts.data(), MPI_DOUBLE,
                mpi_);
  for (int r = 0; r < processes_; ++r) {
    const Rows theirs = rowsOf(r, n);
    const double* block = received.data() + theirs.begin * myColumns.size();
    for (Index j = 0; j < myColumns.size(); ++j)
      std::copy_n(block + j * theirs.size(), theirs.size(),
                  result.column(j) + theirs.begin);
  }
  return result;
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
  if (height > 0) {  // the block on the diagonal, then what is left of it, used twice
    dsymv_("L", &height, &one, lower.column(mine.begin), &ld, x.data() + mine.begin,
           &step, &one, y.data() + mine.begin, &step);
    if (width > 0) {
      dgemv_("N", &height, &width, &one, lower.data(), &ld, x.data(), &step, &one,
             y.data() + mine.begin, &step);
      dgemv_("T", &height, &width, &one, lower.data(), &ld, x.data() + mine.begin, &step,
             &one, y.data(), &step);
    }
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
