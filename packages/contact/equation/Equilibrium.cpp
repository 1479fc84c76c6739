#include "contact/equation/Equilibrium.hpp"

#include "bem/algebra/LeastSquares.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace epafi::contact {

using bem::dot;

namespace {

Vector plus(Vector a, double factor, const Vector& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += factor * b[i];
  return a;
}

/// q scaled by 1 / Σ_i |G_ij|; zero for motions with springs.
struct ScaledLoad {
  Vector scales;
  Vector values;

  explicit ScaledLoad(const Problem& problem) {
    for (Index j = 0; j < problem.rigidMotions(); ++j) {
      const double* g = problem.rigid.column(j);
      double sum = 0;
      for (Index i = 0; i < problem.size(); ++i)
        sum += std::abs(g[i]);
      scales.push_back(problem.stiffness(j) > 0 ? 0 : sum > 0 ? 1 / sum : 1);
      values.push_back(problem.rigidLoad[at(j)] * scales.back());
    }
  }
};

/// The contact forces, scaled like q: a cone and segments from zero.
struct Forces {
  std::vector<Vector> cone;  ///< generators, normalised
  std::vector<Vector> segments;

  Forces(const Problem& problem, const Vector& scales) {
    const auto work = [&](Index i, Index j) { return i < 0 ? 0 : problem.rigid(i, j); };
    const auto add = [&](Index normal, Index tangential, double share, double most) {
      Vector column;
      for (Index j = 0; j < problem.rigidMotions(); ++j)
        column.push_back((work(normal, j) + share * work(tangential, j)) * scales[at(j)]);
      const double length = std::sqrt(dot(column, column));
      const bool bounded = most < unlimited;
      for (double& value : column)
        value *= bounded ? most : 1 / length;
      if (length > 0 && most > 0)
        (bounded ? segments : cone).push_back(std::move(column));
    };
    for (Index i = 0; i < problem.normals; ++i)
      add(i, none, 0, unlimited);
    for (std::size_t t = 0; t < problem.tangentials.size(); ++t) {
      const Tangential& tangential = problem.tangentials[t];
      const Index i = problem.normals + static_cast<Index>(t);
      const double first = tangential.bound(0.0);
      const double slope = tangential.steepest();
      for (const double sign : {-1.0, 1.0}) {
        if (tangential.followsPressure() && slope > 0)
          add(tangential.normal(), i, sign * slope,
              (tangential.largest() - first) / slope);
        add(none, i, sign, first);
      }
    }
  }

 private:
  static constexpr Index none = -1;
  /// Of Young's modulus: contact does not reach such stresses.
  static constexpr double unlimited = 1e3;
};

/// Projection of (q, |q|) onto the cone of all (c, 0) and (z, |q|), by the algorithm of Lawson
/// and Hanson.
class NearestPoint {
 public:
  NearestPoint(const Forces& forces, Vector q)
      : columns_(forces.cone),
        segments_(forces.segments),
        q_(std::move(q)),
        size_(std::sqrt(dot(q_, q_))) {
    for (Vector& column : columns_)
      column.push_back(0);
    q_.push_back(size_);
    rest_ = q_;
  }

  /// (q, |q|) minus its projection, which separates q from the forces if not zero.
  Vector separation() {
    for (std::size_t k = 0; k < 10 * q_.size() + 100; ++k) {
      const std::size_t best = steepest();
      if (dot(columns_[best], rest_) <= 1e-13 * size_)
        break;
      chosen_.push_back(best);
      weights_.push_back(0);
      if (!project())
        return Vector(q_.size(), 0.0);
    }
    return rest_;
  }

  /// Does v separate by more than rounding?
  bool separates(const Vector& v) {
    rest_ = v;
    return dot(columns_[steepest()], v) <= 1e-12 * size_;
  }

 private:
  /// The column that makes the smallest angle with the rest, a new vertex if need be.
  std::size_t steepest() {
    columns_.push_back(vertex());
    std::size_t best = columns_.size() - 1;
    for (std::size_t k = 0; k + 1 < columns_.size(); ++k)
      if (std::find(chosen_.begin(), chosen_.end(), k) == chosen_.end() &&
          dot(columns_[k], rest_) >= dot(columns_[best], rest_))
        best = k;
    if (best + 1 < columns_.size())
      columns_.pop_back();
    return best;
  }

  /// (z, |q|), normalised: the sum of the segments that lie on the side of the rest.
  Vector vertex() const {
    Vector z(q_.size(), 0.0);
    for (const Vector& segment : segments_)
      if (std::inner_product(segment.begin(), segment.end(), rest_.begin(), 0.0) > 0)
        std::transform(segment.begin(), segment.end(), z.begin(), z.begin(),
                       std::plus<>());
    z.back() = size_;
    const double length = std::sqrt(dot(z, z));
    for (double& value : z)
      value /= length;
    return z;
  }

  /// Least squares over the chosen columns; drops columns with negative weights.
  bool project() {
    while (!chosen_.empty()) {
      constexpr double dependent = 1e-12;
      std::vector<Vector> columns;
      for (const std::size_t k : chosen_)
        columns.push_back(columns_[k]);
      const auto [wanted, rank, rest] = bem::leastSquares(columns, q_, dependent);
      if (at(rank) < chosen_.size())
        return false;
      double step = 1;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] <= 0)
          step = std::min(step, weights_[i] / (weights_[i] - wanted[i]));
      weights_ = plus(weights_, step, plus(wanted, -1, weights_));
      if (step == 1)
        break;
      for (std::size_t i = weights_.size(); i-- > 0;)
        if (wanted[i] <= 0 && weights_[i] <= 1e-15) {
          weights_.erase(weights_.begin() + static_cast<std::ptrdiff_t>(i));
          chosen_.erase(chosen_.begin() + static_cast<std::ptrdiff_t>(i));
          return project();
        }
      return false;
    }
    rest_ = q_;
    for (std::size_t i = 0; i < chosen_.size(); ++i)
      rest_ = plus(std::move(rest_), -weights_[i], columns_[chosen_[i]]);
    return true;
  }

  std::vector<Vector> columns_;
  const std::vector<Vector>& segments_;
  Vector q_;
  double size_;
  Vector rest_;
  std::vector<std::size_t> chosen_;
  Vector weights_;
};

/// Do pressures and shear of least length that balance the load keep the laws?  Mostly they do, and
/// no more is asked then.
bool balancesAtOnce(const Problem& problem) {
  constexpr double rounding = 1e-11;  // of the load
  std::vector<Index> free;
  for (Index j = 0; j < problem.rigidMotions(); ++j)
    if (!(problem.stiffness(j) > 0))
      free.push_back(j);
  const auto k = static_cast<Index>(free.size());
  std::vector<std::vector<std::pair<Index, double>>> rows(at(problem.size()));
  for (Index j = 0; j < k; ++j)
    for (Index i = 0; i < problem.size(); ++i)
      if (const double g = problem.rigid(i, free[at(j)]); g != 0)
        rows[at(i)].push_back({j, g});
  Matrix gram(k, k);
  Vector load;
  for (const Index j : free)
    load.push_back(problem.rigidLoad[at(j)]);
  for (const auto& row : rows)
    for (const auto& [j, x] : row)
      for (const auto& [i, y] : row)
        gram(i, j) += x * y;
  if (bem::cholesky(gram) != 0)
    return false;
  Vector sizes = load;
  bem::choleskySolve(gram, bem::MatrixView(sizes));
  Vector forces(rows.size());
  Vector rest = load;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [j, g] : rows[i])
      forces[i] += g * sizes[at(j)];
    for (const auto& [j, g] : rows[i])
      rest[at(j)] -= g * forces[i];
  }
  const auto end = forces.begin() + problem.normals;
  if (!(bem::largestEntry(rest) <= rounding * bem::largestEntry(load)) ||
      std::any_of(forces.begin(), end, [](double p) { return p < 0; }))
    return false;
  const Vector bounds = problem.slipBounds(forces);
  for (std::size_t t = 0; t < bounds.size(); ++t)
    if (std::abs(forces[at(problem.normals) + t]) > bounds[t])
      return false;
  return true;
}

}  // namespace

NoBalance::NoBalance()
    : bem::NumericalError(
          "the load moves the body along a rigid motion that nothing holds: neither "
          "contact nor friction can balance its resultant") {}

UnresistedMotion unresistedMotion(const Problem& problem) {
  constexpr double clear = 1e-10;
  const ScaledLoad load(problem);
  const double size = std::sqrt(dot(load.values, load.values));
  // A resultant that is only rounding error is balanced.
  if (!(size > clear * problem.stress))
    return {};
  if (balancesAtOnce(problem))
    return {};
  const Forces forces(problem, load.scales);
  NearestPoint nearest(forces, load.values);
  Vector v = nearest.separation();
  const double length = std::sqrt(dot(v, v));
  if (!(length > clear * size) || !nearest.separates(v))
    return {};
  v.pop_back();
  UnresistedMotion result{v, dot(v, load.values), 0};
  for (const Vector& segment : forces.segments)
    result.held += std::max(dot(v, segment), 0.0);
  if (!(result.load > result.held))
    return {};
  for (std::size_t j = 0; j < v.size(); ++j)
    result.amplitudes[j] *= load.scales[j];
  return result;
}

void requireEquilibrium(const Problem& problem) {
  if (!unresistedMotion(problem).amplitudes.empty())
    throw NoBalance();
}

}  // namespace epafi::contact
