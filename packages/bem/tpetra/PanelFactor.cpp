#include "bem/tpetra/PanelFactor.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/base/Error.hpp"
#include "bem/tpetra/Redeal.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

constexpr double one = 1;
constexpr double minusOne = -1;

int asInt(Index n) { return static_cast<int>(n); }

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
  dpotrf_("L", &width, panel.data(), &ld, &info);
  if (info != 0)
    panel(0, 0) = -info;
  else if (below > 0)
    dtrsm_("R", "L", "T", "N", &below, &width, &one, panel.data(), &ld,
           panel.data() + width, &ld);
}

/// Panel j, if it is mine, minus what panel k of L contributes to it.
void PanelFactor::update(int j, int k, const PanelStream::View& panel) {
  if (!panels_.isMine(j))
    return;
  Matrix& target = panels_.mine(j);
  const double* part = panel.data + (panels_.begin(j) - panels_.begin(k));
  const int rows = asInt(target.rows());
  const int columns = asInt(target.columns());
  const int depth = asInt(panels_.columns(k));
  const int lda = asInt(panel.stride);
  const int ldc = asInt(target.stride());
  dgemm_("N", "T", &rows, &columns, &depth, &minusOne, part, &lda, part, &lda, &one,
         target.data(), &ldc);
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
      dtrsm_("L", "L", "N", "N", &width, &columns, &one, panel.data, &lda, known, &ldx);
    if (columns > 0 && below > 0)
      dgemm_("N", "N", &below, &columns, &width, &minusOne, panel.data + width, &lda,
             known, &ldx, &one, known + width, &ldx);
  }
  return redeal.toRows(x, std::move(rows));
}

/// L⁻¹ b, the entries of a panel's rows on its owner only.
Vector PanelFactor::forwardOnOwners(const Vector& b) const {
  Vector x = b;
  Vector mine(b.size());  // what my panels contribute to L x
  Vector total(static_cast<std::size_t>(ColumnPanels::width));
  const int step = 1;
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
    dtrsm_("L", "L", "N", "N", &width, &step, &one, panel.data(), &ld, x.data() + begin,
           &width);
    if (below > 0)
      dgemv_("N", &below, &width, &one, panel.data() + width, &ld, x.data() + begin,
             &step, &one, mine.data() + begin + width, &step);
  }
  return x;
}

Vector PanelFactor::solve(const Vector& b) const { return backward(forwardOnOwners(b)); }

// Only a panel's owner reads b there; the result is everybody's.
Vector PanelFactor::backward(const Vector& b) const {
  Vector x = b;
  const int step = 1;
  algebra_.consent().confirm();
  for (int k = panels_.count() - 1; k >= 0; --k) {
    const int width = asInt(panels_.columns(k));
    const int below = asInt(panels_.rows(k)) - width;
    double* mine = x.data() + panels_.begin(k);
    if (panels_.isMine(k)) {
      const Matrix& panel = panels_.mine(k);
      const int ld = asInt(panel.stride());
      if (below > 0)
        dgemv_("T", &below, &width, &minusOne, panel.data() + width, &ld, mine + width,
               &step, &one, mine, &step);
      dtrsm_("L", "L", "T", "N", &width, &step, &one, panel.data(), &ld, mine, &width);
    }
    MPI_Bcast(mine, width, MPI_DOUBLE, panels_.owner(k), panels_.comm());
  }
  return x;
}

}  // namespace epafi::bem
