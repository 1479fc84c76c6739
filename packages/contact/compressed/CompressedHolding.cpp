#include "contact/compressed/CompressedHolding.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

std::vector<int> furtherLeaves(const bem::CompressedOperators& operators) {
  std::vector<int> leaves;
  for (Index i = operators.further(); i < operators.size(); ++i)
    leaves.push_back(operators.leafOf(i));
  return leaves;
}

CompressedHolding::CompressedHolding(const bem::CompressedOperators& operators,
                                     std::size_t body, const Holding& holding,
                                     Vector& densities)
    : operators_(operators),
      holding_(holding),
      range_(operators.range(body)),
      densities_(densities) {
  restriction_.held.assign(at(operators.size()), 1);
  const auto held = restriction_.held.begin();
  std::fill(held + range_.densities, held + range_.last, 0);
  std::copy(holding.loads.clamped.begin(), holding.loads.clamped.end(),
            held + range_.first);
  addSprings();
  // with several bodies, only the factor of CompressedFlexibility is updated
  const bool changes = operators.bodies() == 1;
  factor_ = std::make_unique<const bem::CompressedFactor>(
      operators, restriction_, changes ? furtherLeaves(operators) : std::vector<int>());
}

Vector CompressedHolding::solve(const Vector& force) const {
  const Matrix x = displaced(placed(bem::asColumn(force)));
  densities_.assign(x.data() + range_.densities, x.data() + range_.last);
  Vector u(x.data() + range_.first, x.data() + range_.densities);
  for (Index k = 0; k < holding_.allowed.columns(); ++k) {
    const Vector r = columnOf(holding_.allowed, k);
    bem::axpy(bem::dot(r, force), r, u);
  }
  return u;
}

Matrix CompressedHolding::placed(const Matrix& columns) const {
  Matrix result(operators_.size(), columns.columns());
  for (Index k = 0; k < columns.columns(); ++k)
    std::copy_n(columns.column(k), columns.rows(), result.column(k) + range_.first);
  return result;
}

// One spring per rigid motion that clamps allow, at the pivots of the matrix of motions
// (complete pivoting), rows weighted with the lengths of functionals: a force on a short
// element causes densities, and rounding errors, proportional to 1/h.
void CompressedHolding::addSprings() {
  Matrix motions = holding_.allowed.copy();
  if (motions.columns() == 0)
    return;
  const Matrix& functionals = holding_.functionals;
  Vector lengths(at(motions.rows()));
  for (Index k = 0; k < functionals.columns(); ++k)
    for (Index i = 0; i < functionals.rows(); ++i)
      lengths[at(i)] += std::abs(functionals(i, k));
  // lengths above a quarter of the longest count as equal
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  const auto moved = [&](Index i, Index k) {
    return std::min(lengths[at(i)], 0.25 * longest) * std::abs(motions(i, k));
  };
  for (Index k = 0; k < motions.columns(); ++k) {
    Index row = 0;
    Index column = k;
    for (Index l = k; l < motions.columns(); ++l)
      for (Index i = 0; i < motions.rows(); ++i)
        if (moved(i, l) > moved(row, column)) {
          row = i;
          column = l;
        }
    std::swap_ranges(motions.column(k), motions.column(k) + motions.rows(),
                     motions.column(column));
    restriction_.entries.push_back(
        {range_.first + row, range_.first + row, range_.young});
    for (Index l = k + 1; l < motions.columns(); ++l) {
      const double factor = motions(row, l) / motions(row, k);
      for (Index i = 0; i < motions.rows(); ++i)
        motions(i, l) -= factor * motions(i, k);
    }
  }
}

// A⁺ f = (I - R cᵀ) M⁻¹ (I - c Rᵀ) f: under balanced loads, as many springs as motions
// carry no force
Matrix CompressedHolding::displaced(Matrix forces) const {
  const auto subtract = [&](const Matrix& seen, const Matrix& taken, Matrix& x) {
    for (Index j = 0; j < x.columns(); ++j)
      for (Index k = 0; k < taken.columns(); ++k) {
        double sum = 0;
        for (Index i = 0; i < seen.rows(); ++i)
          sum += seen(i, k) * x(range_.first + i, j);
        for (Index i = 0; i < taken.rows(); ++i)
          x(range_.first + i, j) -= sum * taken(i, k);
      }
  };
  subtract(holding_.allowed, holding_.functionals, forces);
  Matrix x = factor_->solve(forces);
  subtract(holding_.functionals, holding_.allowed, x);
  return x;
}

}  // namespace epafi::contact
