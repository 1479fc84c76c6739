#include "contact/problem/Flexibility.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Parallel.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::contact {

namespace {

using System = Flexibility::Operator::System;

/// The matrix of a system in x of the rows, scaled so that D has a unit diagonal, and in β:
///
///   [ A  B ] [x₁]   [b₁]     x₁: rows without followers, A = D + Ĝ Ĝᵀ there: the balances times Ĝ
///   [ C  E ] [x₂] = [b₂]     are added to these rows.   x₂: leaders and motions β.
///
/// A by Cholesky, since D is positive definite on {Ĝᵀ x = 0}; E - C A⁻¹ B by LU.
class Dense final : public Flexibility::Operator::Factor {
 public:
  Dense(const Matrix& entries, System system)
      : entries_(entries), system_(std::move(system)), place_(at(entries.rows()), -1) {
    orderRows();
    Matrix b(first_, rest());
    Matrix e(rest(), rest());
    factor_ = Matrix(first_, first_);
    lower_ = Matrix(rest(), first_);
    fill(b, e);
    for (Index k = 0; k < motions(); ++k)
      for (Index q = 0; q < first_; ++q)
        for (Index p = q; p < first_; ++p)
          factor_(p, q) += border_(p, k) * border_(q, k);
    addBalances(e, b);
    if (const int info = bem::cholesky(factor_); info != 0)
      throw SingularJacobian(bem::message(
          "singular Newton matrix: the contact flexibility of the active coefficients is "
          "not positive definite (pivot ",
          info, " of ", first_,
          "); two multiplier coefficients may act on the same displacement"));
    answers_ = std::move(b);
    choleskySolve(factor_, answers_);
    bem::addProduct(-1, lower_, answers_, e);
    schur_ = bem::LuFactor(std::move(e));
    const double condition = schur_.reciprocalCondition();
    if (!(condition > std::numeric_limits<double>::epsilon()))
      throw SingularJacobian(bem::message(
          "singular Newton matrix (reciprocal condition ", condition, ")",
          system_.followers.empty() ? " of the balance of the free rigid motions"
                                    : " of Coulomb's problem: at this friction "
                                      "coefficient the solution may not be unique"));
  }

  Matrix solve(Matrix b) const override {
    Matrix x(count() + motions(), b.columns());
    for (Index c = 0; c < b.columns(); ++c)
      reduce(b.column(c), x.column(c));
    const bem::MatrixView known = bem::MatrixView(x).rowsBetween(0, first_);
    const bem::MatrixView y = bem::MatrixView(x).rowsBetween(first_, x.rows());
    addBalances(y, known);
    choleskySolve(factor_, known);
    bem::addProduct(-1, lower_, known, y);
    schur_.solve(y);
    bem::addProduct(-1, answers_, y, known);
    for (Index c = 0; c < b.columns(); ++c) {
      double* to = b.column(c);
      for (Index p = 0; p < count(); ++p)
        to[system_.rows[at(p)]] = scale_[at(p)] * x(p, c);
      for (const auto& [follower, leader, factor] : system_.followers)
        to[follower] += factor * to[leader];
      std::copy_n(x.column(c) + count(), motions(), to + entries_.rows());
    }
    return b;
  }

 private:
  Index count() const { return static_cast<Index>(system_.rows.size()); }
  Index motions() const { return system_.motions.columns(); }
  Index rest() const { return count() - first_ + motions(); }

  /// Leaders last; their places, scales and the scaled Ĝ.
  void orderRows() {
    std::vector<char> leads(place_.size(), 0);
    for (const bem::Entry& follower : system_.followers)
      leads[at(follower.column)] = 1;
    const auto middle = std::stable_partition(system_.rows.begin(), system_.rows.end(),
                                              [&](Index i) { return leads[at(i)] == 0; });
    first_ = middle - system_.rows.begin();
    for (Index p = 0; p < count(); ++p) {
      const Index i = system_.rows[at(p)];
      place_[at(i)] = p;
      scale_.push_back(entries_(i, i));
    }
    for (const auto& [row, column, value] : system_.added)
      if (row == column && place_[at(row)] >= 0)
        scale_[at(place_[at(row)])] += value;
    border_ = Matrix(count(), motions());
    for (Index p = 0; p < count(); ++p) {
      double& scale = scale_[at(p)];
      scale = scale > 0 ? 1 / std::sqrt(scale) : 1;
      for (Index k = 0; k < motions(); ++k)
        border_(p, k) = scale * system_.motions(system_.rows[at(p)], k);
    }
  }

  /// Of A the lower triangle, without Ĝ Ĝᵀ.
  // NOLINTNEXTLINE(readability-function-cognitive-complexity): loops that copy
  void fill(Matrix& b, Matrix& e) {
    for (Index q = 0; q < first_; ++q) {
      addColumn(system_.rows[at(q)], scale_[at(q)], q, first_, factor_.column(q) + q);
      addColumn(system_.rows[at(q)], scale_[at(q)], first_, count(), lower_.column(q));
      for (Index k = 0; k < motions(); ++k)
        lower_(count() - first_ + k, q) = border_(q, k);
    }
    const auto addLeader = [&](Index j, double factor, Index leader) {
      const Index q = leader - first_;
      const double scale = factor * scale_[at(leader)];
      addColumn(j, scale, 0, first_, b.column(q));
      addColumn(j, scale, first_, count(), e.column(q));
      for (Index k = 0; k < motions(); ++k)
        e(count() - first_ + k, q) += scale * system_.motions(j, k);
    };
    for (Index q = first_; q < count(); ++q)
      addLeader(system_.rows[at(q)], 1, q);
    for (const auto& [follower, leader, factor] : system_.followers)
      addLeader(follower, factor, place_[at(leader)]);
    for (Index k = 0; k < motions(); ++k) {
      const Index q = count() - first_ + k;
      for (Index p = 0; p < count(); ++p)
        (p < first_ ? b(p, q) : e(p - first_, q)) = -border_(p, k);
      for (Index l = 0; l < system_.stiffness.columns(); ++l)
        e(q, count() - first_ + l) = system_.stiffness(k, l);
    }
    for (const auto& [row, column, value] : system_.added) {
      const Index p = place_[at(row)];
      const Index q = place_[at(column)];
      if (p >= 0 && q >= 0)
        (q >= first_  ? (p < first_ ? b(p, q - first_) : e(p - first_, q - first_))
         : p < first_ ? factor_(p, q)
                      : lower_(p - first_, q)) += scale_[at(p)] * scale_[at(q)] * value;
    }
  }

  /// Adds to `to` the rows from p = first to last, scaled, of column j of D times a factor.
  void addColumn(Index j, double factor, Index first, Index last, double* to) const {
    const double* column = entries_.column(j);
    for (Index p = first; p < last; ++p)
      to[p - first] += factor * scale_[at(p)] * column[system_.rows[at(p)]];
  }

  /// Adds Ĝ times the balances, the last rows of y, to x.
  void addBalances(bem::ConstMatrixView y, bem::MatrixView x) const {
    for (Index c = 0; c < x.columns(); ++c)
      for (Index k = 0; k < motions(); ++k)
        for (Index p = 0; p < first_; ++p)
          x(p, c) += border_(p, k) * y(count() - first_ + k, c);
  }

  /// Right-hand sides of the rows (scaled) and motions minus the terms of known coefficients.
  void reduce(const double* from, double* to) const {
    for (Index p = 0; p < count(); ++p)
      to[p] = from[system_.rows[at(p)]];
    std::copy_n(from + entries_.rows(), motions(), to + count());
    for (Index j = 0; j < entries_.rows(); ++j) {
      if (place_[at(j)] >= 0 || from[j] == 0)
        continue;
      const double* column = entries_.column(j);
      for (Index p = 0; p < count(); ++p)
        to[p] -= column[system_.rows[at(p)]] * from[j];
      for (Index k = 0; k < motions(); ++k)
        to[count() + k] -= system_.motions(j, k) * from[j];
    }
    for (const auto& [row, column, value] : system_.added)
      if (place_[at(row)] >= 0 && place_[at(column)] < 0)
        to[place_[at(row)]] -= value * from[column];
    for (Index p = 0; p < count(); ++p)
      to[p] *= scale_[at(p)];
  }

  const Matrix& entries_;
  System system_;             ///< rows of leaders last
  std::vector<Index> place_;  ///< index among the rows, by coefficient; -1: none
  Index first_ = 0;           ///< number of rows without followers
  Vector scale_;
  Matrix border_;        ///< scaled Ĝ of the rows
  Matrix factor_;        ///< of A
  Matrix lower_;         ///< C
  Matrix answers_;       ///< A⁻¹ B
  bem::LuFactor schur_;  ///< of E - C A⁻¹ B
};

class DenseFlexibility final : public Flexibility::Operator {
 public:
  explicit DenseFlexibility(Matrix entries) : entries_(std::move(entries)) {
    assert(entries_.rows() == entries_.columns());
  }

  Index size() const override { return entries_.rows(); }
  const Matrix* entries() const override { return &entries_; }
  Matrix formed() const override { return entries_.copy(); }

  Product product(const Vector& x) const override {
    Product sum{Vector(x.size(), 0.0), Vector(x.size(), 0.0)};
    double* value = sum.value.data();
    double* magnitude = sum.magnitude.data();
    overColumns(x, [&](const double* column, double factor, Index first, Index last) {
#pragma omp simd
      for (Index i = first; i < last; ++i) {
        const double term = column[i] * factor;
        value[i] += term;
        magnitude[i] += std::abs(term);
      }
    });
    return sum;
  }

  Vector times(const Vector& x) const override {
    Vector sum(x.size(), 0.0);
    double* value = sum.data();
    overColumns(x, [&](const double* column, double factor, Index first, Index last) {
#pragma omp simd
      for (Index i = first; i < last; ++i)
        value[i] += column[i] * factor;
    });
    return sum;
  }

  std::unique_ptr<Factor> factor(System system) const override {
    return std::make_unique<Dense>(entries_, std::move(system));
  }

 private:
  /// A block of rows on each thread: sums have one order.
  template <class Add>
  void overColumns(const Vector& x, const Add& add) const {
    assert(static_cast<Index>(x.size()) == size());
    const double work = bem::workOfProduct(size(), size(), 1);
    const Index blocks = bem::threadsFor(work);
    const Index rows = (size() + blocks - 1) / blocks;
    bem::parallelFor({blocks, work}, [&](Index k) {
      const Index last = std::min(size(), (k + 1) * rows);
      for (Index j = 0; j < size(); ++j)
        if (x[at(j)] != 0)
          add(entries_.column(j), x[at(j)], k * rows, last);
    });
  }

  Matrix entries_;
};

}  // namespace

Flexibility::Flexibility(Matrix entries)
    : Flexibility(std::make_shared<const DenseFlexibility>(std::move(entries))) {}

Flexibility::Flexibility(std::shared_ptr<const Operator> form)
    : operator_(std::move(form)), entries_(operator_->entries()) {}

const Vector& Flexibility::responses(Index normals) const {
  const std::lock_guard lock(found_->mutex);
  Vector& responses = found_->responses[normals];
  if (!responses.empty())
    return responses;
  Vector found;  // product() may throw
  for (const bool normal : {true, false}) {
    Vector kind(at(size()), normal ? 0.0 : 1.0);
    std::fill_n(kind.begin(), normals, normal ? 1.0 : 0.0);
    const Vector all = product(kind).magnitude;
    found.insert(found.end(), normal ? all.begin() : all.begin() + normals,
                 normal ? all.begin() + normals : all.end());
  }
  return responses = std::move(found);
}

}  // namespace epafi::contact
