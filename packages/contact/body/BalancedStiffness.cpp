#include "contact/body/BalancedStiffness.hpp"

#include "bem/algebra/DoubledSums.hpp"
#include "bem/base/Parallel.hpp"

#include <algorithm>
#include <numeric>

namespace epafi::contact {

namespace {

constexpr Index motions = 3;

// Rows that a thread sums up: each in one order, whatever the number of threads.
constexpr Index rowsAtOnce = 128;
Index panels(Index rows) { return (rows + rowsAtOnce - 1) / rowsAtOnce; }

constexpr double ofEntry = 1;  // ns

}  // namespace

BalancedStiffness::BalancedStiffness(const bem::SteklovPoincare& stiffness,
                                     RigidModes modes,
                                     std::shared_ptr<const bem::TractionRows> tractions,
                                     Vector gamma)
    : stiffness_(&stiffness),
      modes_(std::move(modes)),
      tractions_(std::move(tractions)),
      gamma_(std::move(gamma)) {
  for (Index k = 0; k < motions; ++k) {
    long double square = 0;
    for (Index i = 0; i < modes_.motions.rows(); ++i)
      square += static_cast<long double>(modes_.functionals(i, k)) * modes_.motions(i, k);
    squares_.push_back(static_cast<double>(square));
  }
}

Vector BalancedStiffness::residual(const Vector& force, const Vector& u) const {
  const Extended inner = withoutMotions(u);
  Extended forces = stiffnessTimes(inner);
  subtractStabilisation(inner, forces);
  forces = balanced(std::move(forces));
  Vector rest(u.size());
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = static_cast<double>(force[i] - forces[i]);
  return rest;
}

double BalancedStiffness::stiffnessWork(const Vector& u) const {
  const Extended inner = withoutMotions(u);
  const Extended forces = stiffnessTimes(inner);
  return static_cast<double>(
      std::inner_product(inner.begin(), inner.end(), forces.begin(), 0.0L));
}

// P u
BalancedStiffness::Extended BalancedStiffness::withoutMotions(const Vector& u) const {
  Extended result(u.begin(), u.end());
  for (Index k = 0; k < motions; ++k) {
    const double* functional = modes_.functionals.column(k);
    const double* motion = modes_.motions.column(k);
    long double mean = 0;
    for (std::size_t i = 0; i < u.size(); ++i)
      mean += functional[i] * result[i];
    mean /= squares_[k];
    for (std::size_t i = 0; i < u.size(); ++i)
      result[i] -= mean * motion[i];
  }
  return result;
}

// Pᵀ f
BalancedStiffness::Extended BalancedStiffness::balanced(Extended forces) const {
  for (Index k = motions; k-- > 0;) {
    const double* functional = modes_.functionals.column(k);
    const double* motion = modes_.motions.column(k);
    long double work = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
      work += motion[i] * forces[i];
    work /= squares_[k];
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] -= work * functional[i];
  }
  return forces;
}

// S u from the lower triangle: what stands below the diagonal in a column, then what stands
// before it in a row.
BalancedStiffness::Extended BalancedStiffness::stiffnessTimes(const Extended& u) const {
  const bem::LowerTriangle& lower = stiffness_->stiffness();
  const Index n = lower.size();
  const bem::Doubled x(u);
  Extended below(u.size());
  const double work = ofEntry * 0.5 * static_cast<double>(n * n);
  bem::parallelFor({n, work, 16}, [&](Index j) {
    below[j] = bem::dotDoubled(lower.column(j), n - j, x, j);
  });
  bem::Doubled result(below);
  bem::parallelFor({panels(n), work}, [&](Index k) {
    const Index first = k * rowsAtOnce;
    const Index last = std::min(first + rowsAtOnce, n);
    for (Index j = 0; j < last; ++j) {
      const Index from = std::max(j + 1, first);
      if (from < last)
        bem::addDoubled(u[j], lower.column(j) + (from - j), last - from, result, from);
    }
  });
  return result.joined();
}

// S^ u = R γ Rᵀ u with the tractions R.
void BalancedStiffness::subtractStabilisation(const Extended& u, Extended& forces) const {
  if (tractions_ == nullptr)
    return;
  const bem::Matrix& rows = tractions_->rows;
  const Index columns = tractions_->start.back();
  const bem::Doubled x(u);
  Extended tractions(columns);
  const double work = ofEntry * static_cast<double>(rows.rows() * columns);
  bem::parallelFor({columns, work, 16}, [&](Index c) {
    tractions[c] = bem::dotDoubled(rows.column(c), rows.rows(), x, 0);
  });
  for (std::size_t k = 0; k < gamma_.size(); ++k)
    for (Index c = tractions_->start[k]; c < tractions_->start[k + 1]; ++c)
      tractions[c] *= gamma_[k];
  bem::Doubled stabilisation(u.size());
  bem::parallelFor({panels(rows.rows()), work}, [&](Index k) {
    const Index first = k * rowsAtOnce;
    const Index last = std::min(first + rowsAtOnce, rows.rows());
    for (Index c = 0; c < columns; ++c)
      bem::addDoubled(tractions[c], rows.column(c) + first, last - first, stabilisation,
                      first);
  });
  const Extended all = stabilisation.joined();
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] -= all[i];
}

}  // namespace epafi::contact
