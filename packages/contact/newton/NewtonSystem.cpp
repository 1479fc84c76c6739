#include "contact/newton/NewtonSystem.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

// A combination of rigid motions counts as held if its singular value in the inactive rows exceeds
// this fraction of the largest: contact on a millionth of a side holds a rotation.
constexpr double heldThreshold = 1e-9;

/// diag(factors) M
Matrix withScaledRows(const Matrix& m, const Vector& factors) {
  Matrix result = m.copy();
  for (Index j = 0; j < m.columns(); ++j)
    for (Index i = 0; i < m.rows(); ++i)
      result(i, j) *= factors[at(i)];
  return result;
}

/// A B, B with few entries in its columns where bodies are many.
Matrix combined(const Matrix& a, const Matrix& b) {
  Matrix result(a.rows(), b.columns());
  for (Index j = 0; j < b.columns(); ++j)
    for (Index k = 0; k < b.rows(); ++k)
      if (const double factor = b(k, j); factor != 0)
        for (Index i = 0; i < a.rows(); ++i)
          result(i, j) += factor * a(i, k);
  return result;
}

Matrix unitMatrix(Index k) {
  Matrix unit(k, k);
  for (Index j = 0; j < k; ++j)
    unit(j, j) = 1;
  return unit;
}

/// Amplitudes of the motions that the rows of A constrain (held) and of those that they do not.
struct Split {
  Matrix held;
  Matrix loose;
};

/// Do the rows hold all motions well?  By the Gram matrix, less than that of an eigenvalue: rows have few
/// motions where bodies are many.
bool holdsAllWell(const Matrix& a, double wellHeld) {
  const Index k = a.columns();
  Matrix gram(k, k);
  std::vector<std::vector<std::pair<Index, double>>> rows(at(a.rows()));
  for (Index j = 0; j < k; ++j)
    for (Index i = 0; i < a.rows(); ++i)
      if (a(i, j) != 0)
        rows[at(i)].push_back({j, a(i, j)});
  for (const auto& row : rows)
    for (const auto& [j, x] : row)
      for (const auto& [i, y] : row)
        gram(i, j) += x * y;
  double largest = 0;  // at least the largest eigenvalue
  for (Index j = 0; j < k; ++j) {
    double sum = 0;
    for (Index i = 0; i < k; ++i)
      sum += std::abs(gram(i, j));
    largest = std::max(largest, sum);
  }
  for (Index j = 0; j < k; ++j)
    gram(j, j) -= wellHeld * wellHeld * largest;
  return bem::cholesky(gram) == 0;
}

Split splitBy(Matrix a, double wellHeld) {
  const Index k = a.columns();
  if (holdsAllWell(a, wellHeld))
    return {unitMatrix(k), Matrix(k, 0)};
  const bem::Svd svd = bem::singularValues(std::move(a));
  const double largest = svd.s.empty() ? 0 : svd.s.front();
  const Index rank = bem::rank(svd, heldThreshold * largest);
  const Matrix v = bem::transposed(svd.vt);
  Split split{bem::columnsBetween(v, 0, rank).copy(),
              bem::columnsBetween(v, rank, k).copy()};
  // well held: the unit vectors
  if (rank == k && svd.s.back() > wellHeld * largest)
    return {unitMatrix(k), std::move(split.loose)};
  for (Index j = 0; j < rank; ++j)
    for (Index i = 0; i < k; ++i)
      split.held(i, j) *= largest / svd.s[at(j)];
  return split;
}

}  // namespace

NewtonSystem::NewtonSystem(const Equation& equation, const Evaluation& at)
    : equation_(equation), rows_(at), problem_(equation.problem()) {
  for (Index i = 0; i < problem_.size(); ++i)
    if (!isKnown(i))
      inactive_.push_back(i);
  splitMotions();
  factor_ = problem_.flexibility.factor(reduced());
}

std::pair<Index, double> NewtonSystem::followed(Index i) const {
  const std::size_t t = at(i - problem_.normals);
  if (i < problem_.normals || problem_.tangentials[t].isTied())
    return {0, 0.0};
  return {problem_.tangentials[t].normal(),
          -rows_.rows[at(i)].bound * rows_.stepBounds[t].slope};
}

void NewtonSystem::splitMotions() {
  const Index k = problem_.rigidMotions();
  const Matrix& rigid = problem_.rigid;
  const double leastHeld = problem_.flexibility.leastHeld();
  for (Index m = 0; m < k; ++m) {
    double sum = problem_.stiffness(m);
    for (Index i = 0; i < problem_.size(); ++i)
      sum += rigid(i, m) * rigid(i, m) * rows_.weights[at(i)];
    motionScale_.push_back(sum > 0 ? 1 / std::sqrt(sum) : 1);
  }
  const auto rows = static_cast<Index>(inactive_.size());
  const bool sprung = !problem_.rigidStiffness.empty();
  Matrix constraints(rows + (sprung ? k : 0), k);
  for (Index m = 0; m < k; ++m)
    for (Index p = 0; p < rows; ++p)
      constraints(p, m) = motionScale_[at(m)] * rigid(inactive_[at(p)], m) *
                          std::sqrt(rows_.weights[at(inactive_[at(p)])]);
  if (sprung) {
    unpressed_ = splitBy(constraints.copy(), leastHeld).loose;
    for (Index m = 0; m < k; ++m)
      constraints(rows + m, m) = motionScale_[at(m)] * std::sqrt(problem_.stiffness(m));
  }
  Split split = splitBy(std::move(constraints), leastHeld);
  held_ = std::move(split.held);
  loose_ = std::move(split.loose);
}

Flexibility::Operator::System NewtonSystem::reduced() const {
  Flexibility::Operator::System system{inactive_, {}, {}, rows_.slopes};
  for (Index i = 0; i < problem_.size(); ++i)
    if (const auto [normal, factor] = followed(i);
        isKnown(i) && factor != 0 && !isKnown(normal))
      system.followers.push_back({i, normal, factor});
  // substitutes leaders for followers in Φ'
  for (const auto& [row, column, value] : rows_.slopes)
    if (row != column && !isKnown(row) && isKnown(column))
      if (const auto [normal, factor] = followed(column); factor != 0 && !isKnown(normal))
        system.added.push_back({row, normal, factor * value});
  const Matrix combinations = withScaledRows(held_, motionScale_);
  system.motions = combined(problem_.rigid, combinations);
  if (!problem_.rigidStiffness.empty())
    system.stiffness = transposedProduct(
        combinations, withScaledRows(combinations, problem_.rigidStiffness));
  return system;
}

Vector NewtonSystem::knownChanges(const Vector& b) const {
  Vector d(at(problem_.size()), 0.0);
  for (Index i = 0; i < problem_.size(); ++i)
    if (isKnown(i)) {
      d[at(i)] = b[at(i)];
      if (const auto [normal, factor] = followed(i); factor != 0 && isKnown(normal))
        d[at(i)] += factor * d[at(normal)];
    }
  return d;
}

Vector NewtonSystem::balance(const Vector& b) const {
  Vector scaled;
  for (std::size_t m = 0; m < motionScale_.size(); ++m)
    scaled.push_back(b[at(problem_.size()) + m] * equation_.balanceScales()[m] *
                     motionScale_[m]);
  return scaled;
}

Vector NewtonSystem::byFactor(const Vector& b) const {
  Vector right = knownChanges(b);
  for (const Index i : inactive_)
    right[at(i)] = b[at(i)] / rows_.weights[at(i)];
  const Vector balances = transposedProduct(held_, balance(b));
  right.insert(right.end(), balances.begin(), balances.end());
  const Matrix solution = factor_->solve(bem::ConstMatrixView(right).copy());
  const double* sizes = solution.column(0) + problem_.size();
  Vector d(solution.column(0), sizes);
  for (Index m = 0; m < held_.rows(); ++m) {
    double sum = 0;
    for (Index j = 0; j < held_.columns(); ++j)
      sum += held_(m, j) * sizes[j];
    d.push_back(motionScale_[at(m)] * sum);
  }
  return d;
}

Vector NewtonSystem::solve(const Vector& b) const {
  Vector d = byFactor(b);
  Vector defect = b;
  bem::axpy(-1, equation_.jacobianTimes(rows_, d), defect);
  bem::axpy(1, byFactor(defect), d);
  return d;
}

Vector NewtonSystem::demanded(const Matrix& combinations, const Vector& b) const {
  if (combinations.columns() == 0)
    return {};
  const Index k = problem_.rigidMotions();
  Vector rest = balance(b);
  const Vector known = knownChanges(b);
  for (Index m = 0; m < k; ++m)
    for (Index i = 0; i < problem_.size(); ++i)
      rest[at(m)] -= motionScale_[at(m)] * problem_.rigid(i, m) * known[at(i)];
  Vector direction(at(k), 0.0);
  for (Index j = 0; j < combinations.columns(); ++j) {
    const Vector motion = columnOf(combinations, j);
    const double share = bem::dot(motion, rest);
    for (Index m = 0; m < k; ++m)
      direction[at(m)] += motionScale_[at(m)] * motion[at(m)] * share;
  }
  // Rounding errors of the balance do not count.
  double demand = 0;
  for (Index m = 0; m < k; ++m)
    demand =
        std::max(demand, std::abs(direction[at(m)]) / motionScale_[at(m)] /
                             (motionScale_[at(m)] * equation_.balanceScales()[at(m)]));
  return demand > 1e-10 * problem_.stress ? direction : Vector{};
}

}  // namespace epafi::contact
