#include "bem/tpetra/PanelFactor.hpp"

#include "bem/base/Error.hpp"
#include "bem/tpetra/Redeal.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <cmath>

namespace epafi::bem {

namespace {

using Blas = Teuchos::BLAS<int, double>;
using Teuchos::LEFT_SIDE;
using Teuchos::LOWER_TRI;
using Teuchos::NO_TRANS;
using Teuchos::NON_UNIT_DIAG;
using Teuchos::TRANS;

}  // namespace

// Right-looking, one panel ahead: whoever has the next panel brings it up to date first,
// factorises it and sends it off; it travels while all bring up to date what they have of
// the others.
PanelFactor::PanelFactor(ColumnPanels matrix, const TpetraAlgebra& algebra,
                         const char* name)
    : panels_(std::move(matrix)), algebra_(algebra) {
  if (panels_.count() == 0)
    return;
  PanelStream stream(panels_);
  algebra_.consent().confirm();
  factorise(0);
  stream.begin(0);
  for (int k = 0; k < panels_.count(); ++k) {
    const PanelStream::View panel = stream.end(k);
    if (panel.data[0] < 0)
      throw NumericalError(
          message(name, " is not positive definite: Cholesky's factorisation ",
                  "breaks down in row ", panels_.begin(k) - std::lround(panel.data[0]),
                  " of ", panels_.size()));
    if (k + 1 < panels_.count()) {
      update(k + 1, k, panel);
      factorise(k + 1);
      stream.begin(k + 1);
    }
    for (int j = k + 2; j < panels_.count(); ++j)
      update(j, k, panel);
  }
}

/// L's panel k, if it is mine.  Where the factorisation breaks down in row i, counted
/// from 1, its first entry becomes -i: so the panel itself tells the others.
void PanelFactor::factorise(int k) {
  if (!panels_.isMine(k))
    return;
  Matrix& panel = panels_.mine(k);
  const int width = asInt(panel.columns());
  const int below = asInt(panel.rows()) - width;
  const int ld = asInt(panel.stride());
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', width, panel.data(), ld, &info);
  if (info != 0)
    panel(0, 0) = -info;
  else if (below > 0)
    Blas().TRSM(Teuchos::RIGHT_SIDE, LOWER_TRI, TRANS, NON_UNIT_DIAG, below, width, 1,
                panel.data(), ld, panel.data() + width, ld);
}

/// Panel j, if it is mine, minus what panel k of L contributes to it.
void PanelFactor::update(int j, int k, const PanelStream::View& panel) {
  if (!panels_.isMine(j))
    return;
  Matrix& target = panels_.mine(j);
  const double* part = panel.data + (panels_.begin(j) - panels_.begin(k));
  const int ld = asInt(panel.stride);
  Blas().GEMM(NO_TRANS, TRANS, asInt(target.rows()), asInt(target.columns()),
              asInt(panels_.columns(k)), -1, part, ld, part, ld, 1, target.data(),
              asInt(target.stride()));
}

// Every process solves for the columns that it has: all of L passes by, B stays.
Matrix PanelFactor::forward(Matrix rows) const {
  const Index n = panels_.size();
  Redeal redeal(panels_.comm(), n, rows.columns());
  Matrix x(n, redeal.columns());
  PanelStream stream(panels_);
  algebra_.consent().confirm();
  x = redeal.toColumns(rows, std::move(x));
  const int columns = asInt(x.columns());
  const int ldx = asInt(x.stride());
  if (panels_.count() > 0)
    stream.begin(0);
  for (int k = 0; k < panels_.count(); ++k) {
    const PanelStream::View panel = stream.end(k);
    if (k + 1 < panels_.count())
      stream.begin(k + 1);
    const int width = asInt(panels_.columns(k));
    const int below = asInt(panels_.rows(k)) - width;
    const int lda = asInt(panel.stride);
    double* known = x.data() + panels_.begin(k);
    if (columns > 0)
      Blas().TRSM(LEFT_SIDE, LOWER_TRI, NO_TRANS, NON_UNIT_DIAG, width, columns, 1,
                  panel.data, lda, known, ldx);
    if (columns > 0 && below > 0)
      Blas().GEMM(NO_TRANS, NO_TRANS, below, columns, width, -1, panel.data + width, lda,
                  known, ldx, 1, known + width, ldx);
  }
  return redeal.toRows(x, std::move(rows));
}

/// L⁻¹ b, the entries of a panel's rows on its owner only.
Vector PanelFactor::forwardOnOwners(const Vector& b) const {
  Vector x = b;
  Vector mine(b.size());  // what my panels contribute to L x
  Vector total(static_cast<std::size_t>(ColumnPanels::width));
  algebra_.consent().confirm();
  for (int k = 0; k < panels_.count(); ++k) {
    const int width = asInt(panels_.columns(k));
    const int below = asInt(panels_.rows(k)) - width;
    const Index begin = panels_.begin(k);
    MPI_Reduce(mine.data() + begin, total.data(), width, MPI_DOUBLE, MPI_SUM,
               panels_.owner(k), panels_.comm());
    if (!panels_.isMine(k))
      continue;
    const Matrix& panel = panels_.mine(k);
    const int ld = asInt(panel.stride());
    for (int i = 0; i < width; ++i)
      x[begin + i] -= total[i];
    Blas().TRSM(LEFT_SIDE, LOWER_TRI, NO_TRANS, NON_UNIT_DIAG, width, 1, 1, panel.data(),
                ld, x.data() + begin, width);
    if (below > 0)
      Blas().GEMV(NO_TRANS, below, width, 1, panel.data() + width, ld, x.data() + begin,
                  1, 1, mine.data() + begin + width, 1);
  }
  return x;
}

Vector PanelFactor::solve(const Vector& b) const { return backward(forwardOnOwners(b)); }

// Only a panel's owner reads b there; the result is everybody's.
Vector PanelFactor::backward(const Vector& b) const {
  Vector x = b;
  algebra_.consent().confirm();
  for (int k = panels_.count() - 1; k >= 0; --k) {
    const int width = asInt(panels_.columns(k));
    const int below = asInt(panels_.rows(k)) - width;
    double* mine = x.data() + panels_.begin(k);
    if (panels_.isMine(k)) {
      const Matrix& panel = panels_.mine(k);
      const int ld = asInt(panel.stride());
      if (below > 0)
        Blas().GEMV(TRANS, below, width, -1, panel.data() + width, ld, mine + width, 1, 1,
                    mine, 1);
      Blas().TRSM(LEFT_SIDE, LOWER_TRI, TRANS, NON_UNIT_DIAG, width, 1, 1, panel.data(),
                  ld, mine, width);
    }
    MPI_Bcast(mine, width, MPI_DOUBLE, panels_.owner(k), panels_.comm());
  }
  return x;
}

}  // namespace epafi::bem
