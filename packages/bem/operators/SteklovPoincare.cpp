#include "bem/operators/SteklovPoincare.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/operators/ExactRotation.hpp"

#include <algorithm>
#include <utility>

namespace epafi::bem {

namespace {

/// V + G, the lower triangle.
Matrix added(Matrix lower, const LocalCompliance& compliance) {
  for (std::size_t k = 0; k < compliance.densities.size(); ++k)
    lower(compliance.densities[k], compliance.densities[k]) += compliance.diagonal[k];
  for (const auto& [i, value] : compliance.pinned)
    lower(i, i) += value;
  return lower;
}

/// All of 0 ... n - 1, the given ones last.
std::vector<Index> withLast(Index n, const std::vector<Index>& last) {
  std::vector<bool> isLast(static_cast<std::size_t>(n), false);
  for (const Index i : last)
    isLast[static_cast<std::size_t>(i)] = true;
  std::vector<Index> order;
  for (Index i = 0; i < n; ++i)
    if (!isLast[static_cast<std::size_t>(i)])
      order.push_back(i);
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

Matrix rowsInOrder(Matrix a, const std::vector<Index>& order) {
  const double work = workOfNumbers(3.0 * static_cast<double>(a.rows() * a.columns()));
  parallelFor({a.columns(), work, 16}, [&](Index j) {
    double* column = a.column(j);
    const Vector before(column, column + a.rows());
    for (std::size_t i = 0; i < order.size(); ++i)
      column[i] = before[static_cast<std::size_t>(order[i])];
  });
  return a;
}

/// The lower triangle of P A Pᵀ.
Matrix symmetricInOrder(const Matrix& lower, const std::vector<Index>& order) {
  const auto n = static_cast<Index>(order.size());
  Matrix result(n, n);
  const double work = workOfNumbers(2.0 * static_cast<double>(n * n));
  parallelFor({n, work, 16}, [&](Index j) {
    const Index column = order[static_cast<std::size_t>(j)];
    for (Index i = j; i < n; ++i) {
      const Index row = order[static_cast<std::size_t>(i)];
      result(i, j) = lower(std::max(row, column), std::min(row, column));
    }
  });
  return result;
}

/// A beside the unit vectors of some densities.
Matrix besideUnits(const Matrix& a, const std::vector<Index>& units) {
  Matrix result(a.rows(), a.columns() + static_cast<Index>(units.size()));
  for (Index j = 0; j < a.columns(); ++j)
    std::copy_n(a.column(j), a.rows(), result.column(j));
  for (std::size_t k = 0; k < units.size(); ++k)
    result(units[k], a.columns() + static_cast<Index>(k)) = 1;
  return result;
}

void fillUpper(Matrix& lower) {
  for (Index j = 0; j < lower.columns(); ++j)
    for (Index i = j + 1; i < lower.rows(); ++i)
      lower(j, i) = lower(i, j);
}

}  // namespace

SteklovPoincare::SteklovPoincare(Operators operators, const LocalCompliance& compliance)
    : rotation_(operators.rotation) {
  Matrix v = added(std::move(operators.singleLayer), compliance);
  Matrix k = std::move(operators.doubleLayer);
  if (!compliance.densities.empty()) {
    order_ = withLast(v.columns(), compliance.densities);
    v = symmetricInOrder(v, order_);
    k = rowsInOrder(std::move(k), order_);
  }
  factor_.emplace(std::move(v), "the single layer potential V");
  solvedDoubleLayer_ = factor_->forward(std::move(k));
  stiffness_ =
      LowerTriangle(addGram(std::move(operators.hypersingular), solvedDoubleLayer_));
  if (compliance.densities.empty())
    return;
  // with T = L⁻¹ E, all of which is in the last rows:  Yᵀ T  and  Tᵀ T
  const auto count = static_cast<Index>(compliance.densities.size());
  const Matrix t = factor_->inverseOfLast(count);
  Matrix displacements =
      transposedProduct(rowsBetween(solvedDoubleLayer_, solvedDoubleLayer_.rows() - count,
                                    solvedDoubleLayer_.rows()),
                        t);
  Matrix gram = addGram(Matrix(count, count), t);
  fillUpper(gram);
  response_ = std::make_shared<ComplianceResponse>(ComplianceResponse{
      compliance.densities, std::move(displacements), std::move(gram)});
}

SteklovPoincare::SteklovPoincare(Operators operators, const SingleLayerSolver& solver,
                                 const LocalCompliance& compliance)
    : rotation_(operators.rotation) {
  const Matrix& k = operators.doubleLayer;
  const auto count = static_cast<Index>(compliance.densities.size());
  Matrix v = added(std::move(operators.singleLayer), compliance);
  solvedDoubleLayer_ =
      count > 0 ? solver.solve(std::move(v), besideUnits(k, compliance.densities))
                : solver.solve(std::move(v), k);
  units_ = columnsBetween(solvedDoubleLayer_, k.columns(), k.columns() + count).copy();
  solvedDoubleLayer_.shrink(k.columns());
  addTransposedProduct(1, k, solvedDoubleLayer_, operators.hypersingular);
  stiffness_ = LowerTriangle(std::move(operators.hypersingular));
  if (count == 0)
    return;
  Matrix density = rowsOf(units_, compliance.densities);
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i < j; ++i)
      density(i, j) = density(j, i) = 0.5 * (density(i, j) + density(j, i));
  response_ = std::make_shared<ComplianceResponse>(ComplianceResponse{
      compliance.densities, transposedProduct(k, units_), std::move(density)});
}

Vector SteklovPoincare::apply(const Vector& u) const { return stiffness_.times(u); }

Vector SteklovPoincare::density(const Vector& u) const {
  Vector psi = product(solvedDoubleLayer_, u);
  return factor_ ? unordered(factor_->backward(psi)) : psi;
}

Vector SteklovPoincare::density(const Vector& u, const Vector& b) const {
  Vector psi = density(u);
  if (response_ == nullptr)
    return psi;
  Vector right(psi.size());
  for (std::size_t k = 0; k < b.size(); ++k)
    right[static_cast<std::size_t>(response_->densities[k])] = b[k];
  const Vector less = densityOf(right);
  for (std::size_t i = 0; i < psi.size(); ++i)
    psi[i] -= less[i];
  return psi;
}

Vector SteklovPoincare::densityOf(const Vector& b) const {
  if (factor_)
    return unordered(factor_->solve(ordered(b)));
  Vector rest = b;
  Vector known;
  if (response_ != nullptr)
    for (const Index k : response_->densities)
      known.push_back(std::exchange(rest[at(k)], 0.0));
  if (std::any_of(rest.begin(), rest.end(), [](double x) { return x != 0; }))
    throw InputError(
        "Solver->Linear->Method = Belos cannot have body loads on a body with Poisson's "
        "Ratio = 1/2 and a line without contact; Dense and Compressed can");
  return known.empty() ? rest : product(units_, known);
}

Vector SteklovPoincare::ordered(const Vector& b) const {
  Vector result = b;
  for (std::size_t i = 0; i < order_.size(); ++i)
    result[i] = b[static_cast<std::size_t>(order_[i])];
  return result;
}

Vector SteklovPoincare::unordered(const Vector& b) const {
  Vector result = b;
  for (std::size_t i = 0; i < order_.size(); ++i)
    result[static_cast<std::size_t>(order_[i])] = b[i];
  return result;
}

Matrix SteklovPoincare::addAdjointDensity(Matrix c, Matrix b) const {
  if (rotation_ != nullptr)
    c = withoutRotation(std::move(c), *rotation_);
  if (factor_)
    b = factor_->forward(order_.empty() ? std::move(b)
                                        : rowsInOrder(std::move(b), order_));
  addTransposedProduct(1, solvedDoubleLayer_, b, c);
  return c;
}

}  // namespace epafi::bem
