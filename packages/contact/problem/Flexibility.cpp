#include "contact/problem/Flexibility.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/SmallAlgebra.hpp"

#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::contact {

namespace {

using bem::asInt;
using System = Flexibility::Operator::System;

/// D in the rows and Ĝ, scaled so that D has a unit diagonal.
class Dense : public Flexibility::Operator::Factor {
 public:
  Dense(const Matrix& entries, System system)
      : system_(std::move(system)),
        place_(at(entries.rows()), -1),
        border_(count(), motions()),
        entries_(entries) {
    Vector diagonal(at(count()));
    for (Index p = 0; p < count(); ++p) {
      const Index i = system_.rows[at(p)];
      place_[at(i)] = p;
      diagonal[at(p)] = entries(i, i);
    }
    for (const auto& [row, column, value] : system_.added)
      if (row == column && place_[at(row)] >= 0)
        diagonal[at(place_[at(row)])] += value;
    for (Index p = 0; p < count(); ++p) {
      const Index i = system_.rows[at(p)];
      scale_.push_back(diagonal[at(p)] > 0 ? 1 / std::sqrt(diagonal[at(p)]) : 1);
      for (Index k = 0; k < motions(); ++k)
        border_(p, k) = scale_[at(p)] * system_.motions(i, k);
    }
  }

  Matrix solve(Matrix b) const final {
    const Index n = entries_.rows();
    Matrix x(count() + motions(), b.columns());
    for (Index c = 0; c < b.columns(); ++c)
      reduce(b.column(c), x.column(c));
    solveScaled(x);
    for (Index c = 0; c < b.columns(); ++c) {
      double* to = b.column(c);
      for (Index p = 0; p < count(); ++p)
        to[system_.rows[at(p)]] = scale_[at(p)] * x(p, c);
      for (const auto& [follower, leader, factor] : system_.followers)
        to[follower] += factor * to[leader];
      std::copy_n(x.column(c) + count(), motions(), to + n);
    }
    return b;
  }

 protected:
  /// Solves in place for columns of scaled coefficients x and motions β.
  virtual void solveScaled(Matrix& x) const = 0;

  Index count() const { return static_cast<Index>(system_.rows.size()); }
  Index motions() const { return system_.motions.columns(); }

  /// D in the rows, scaled, as the first block of a matrix of this size.
  Matrix scaled(Index size) const {
    Matrix m(size, size);
    for (Index q = 0; q < count(); ++q)
      addColumn(system_.rows[at(q)], 1, q, m);
    for (const auto& [row, column, value] : system_.added) {
      const Index p = place_[at(row)];
      const Index q = place_[at(column)];
      if (p >= 0 && q >= 0)
        m(p, q) += scale_[at(p)] * scale_[at(q)] * value;
    }
    return m;
  }

  /// Adds factor times column j of D to column q of m, both scaled.
  void addColumn(Index j, double factor, Index q, Matrix& m) const {
    const double* column = entries_.column(j);
    for (Index p = 0; p < count(); ++p)
      m(p, q) += scale_[at(p)] * scale_[at(q)] * factor * column[system_.rows[at(p)]];
  }

  const System system_;
  std::vector<Index> place_;  ///< index among the rows, by coefficient; -1: none
  Vector scale_;
  Matrix border_;  ///< scaled Ĝ of the rows

 private:
  /// Right-hand sides of the rows (scaled) and motions minus the terms of known
  /// coefficients.
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
};

void factorPositive(Matrix& a, const char* name) {
  const int info = cholesky(a);
  if (info != 0)
    throw SingularJacobian(
        bem::message("singular Newton matrix: ", name,
                     " is not positive definite (pivot ", info, " of ", a.rows(),
                     "); two multiplier coefficients may act on the same displacement"));
}

// M x - Ĝ β = b, Ĝᵀ x = q  is equivalent to  (M + Ĝ Ĝᵀ) x - Ĝ β = b + Ĝ q, Ĝᵀ x = q.
class ByCholesky final : public Dense {
 public:
  ByCholesky(const Matrix& entries, System system)
      : Dense(entries, std::move(system)),
        factor_(scaled(count())),
        solvedBorder_(border_.copy()) {
    for (Index k = 0; k < motions(); ++k)
      for (Index q = 0; q < count(); ++q)
        for (Index p = 0; p < count(); ++p)
          factor_(p, q) += border_(p, k) * border_(q, k);
    factorPositive(factor_, "the contact flexibility of the active coefficients");
    for (Index k = 0; k < motions(); ++k)
      choleskySolve(factor_, solvedBorder_.column(k));
    schur_ = transposedTimes(border_, solvedBorder_);
    factorPositive(schur_, "the balance of the free rigid motions");
  }

 private:
  void solveScaled(Matrix& x) const override {
    for (Index c = 0; c < x.columns(); ++c) {
      double* b = x.column(c);
      double* q = b + count();
      for (Index k = 0; k < motions(); ++k)
        for (Index p = 0; p < count(); ++p)
          b[p] += border_(p, k) * q[k];
    }
    choleskySolve(factor_, x.data(), x.columns(), x.stride());
    for (Index c = 0; c < x.columns(); ++c) {
      double* b = x.column(c);
      double* sizes = b + count();
      for (Index k = 0; k < motions(); ++k)
        for (Index p = 0; p < count(); ++p)
          sizes[k] -= border_(p, k) * b[p];
      choleskySolve(schur_, sizes);
      for (Index k = 0; k < motions(); ++k)
        for (Index p = 0; p < count(); ++p)
          b[p] += solvedBorder_(p, k) * sizes[k];
    }
  }

  Matrix factor_;        // of M + Ĝ Ĝᵀ
  Matrix solvedBorder_;  // (M + Ĝ Ĝᵀ)⁻¹ Ĝ
  Matrix schur_;         // the factor of Ĝᵀ (M + Ĝ Ĝᵀ)⁻¹ Ĝ
};

class ByLu final : public Dense {
 public:
  ByLu(const Matrix& entries, System system) : Dense(entries, std::move(system)) {
    Matrix m = matrix();
    equilibrate(m);
    lu_ = bem::LuFactor(std::move(m));
    const double condition = lu_.reciprocalCondition();
    if (!(condition > std::numeric_limits<double>::epsilon()))
      throw SingularJacobian(bem::message(
          "singular Newton matrix (reciprocal condition ", condition, ")",
          system_.followers.empty() ? ""
                                    : " of Coulomb's problem: at this friction "
                                      "coefficient the solution may not be unique"));
  }

 private:
  Matrix matrix() const {
    Matrix m = scaled(count() + motions());
    for (Index k = 0; k < motions(); ++k)
      for (Index p = 0; p < count(); ++p) {
        m(p, count() + k) = -border_(p, k);
        m(count() + k, p) = border_(p, k);
      }
    for (Index l = 0; l < system_.stiffness.columns(); ++l)
      for (Index k = 0; k < motions(); ++k)
        m(count() + k, count() + l) = system_.stiffness(k, l);
    for (const auto& [follower, leader, factor] : system_.followers) {
      const Index q = place_[at(leader)];
      addColumn(follower, factor, q, m);
      for (Index k = 0; k < motions(); ++k)
        m(count() + k, q) += scale_[at(q)] * factor * system_.motions(follower, k);
    }
    return m;
  }

  // Rows differ by the stiffness of bodies.
  void equilibrate(Matrix& m) {
    const int size = asInt(m.columns());
    rowScale_.assign(at(m.columns()), 1.0);
    columnScale_ = rowScale_;
    double least = 0;
    double largest = 0;
    int info = 0;
    if (size > 0)
      Teuchos::LAPACK<int, double>().GEEQU(size, size, m.data(), asInt(m.stride()),
                                           rowScale_.data(), columnScale_.data(), &least,
                                           &least, &largest, &info);
    for (Index j = 0; j < m.columns() && info == 0; ++j)
      for (Index i = 0; i < m.rows(); ++i)
        m(i, j) *= rowScale_[at(i)] * columnScale_[at(j)];
  }

  void solveScaled(Matrix& x) const override {
    scaleRows(rowScale_, x);
    lu_.solve(x);
    scaleRows(columnScale_, x);
  }

  static void scaleRows(const Vector& scale, Matrix& x) {
    for (Index c = 0; c < x.columns(); ++c)
      for (Index i = 0; i < x.rows(); ++i)
        x(i, c) *= scale[at(i)];
  }

  bem::LuFactor lu_;
  Vector rowScale_;
  Vector columnScale_;
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
    overColumns(x, [&](const double* column, double factor) {
#pragma omp simd
      for (std::size_t i = 0; i < x.size(); ++i) {
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
    overColumns(x, [&](const double* column, double factor) {
#pragma omp simd
      for (std::size_t i = 0; i < x.size(); ++i)
        value[i] += column[i] * factor;
    });
    return sum;
  }

  // Without followers and springs, D in the rows is symmetric positive definite on {Ĝᵀ x = 0}.
  std::unique_ptr<Factor> factor(System system) const override {
    if (system.followers.empty() && system.stiffness.empty())
      return std::make_unique<ByCholesky>(entries_, std::move(system));
    return std::make_unique<ByLu>(entries_, std::move(system));
  }

 private:
  template <class Add>
  void overColumns(const Vector& x, const Add& add) const {
    assert(static_cast<Index>(x.size()) == size());
    for (std::size_t j = 0; j < x.size(); ++j)
      if (x[j] != 0)
        add(entries_.column(static_cast<Index>(j)), x[j]);
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
