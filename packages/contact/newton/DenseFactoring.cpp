#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/newton/Factoring.hpp"

#include <Teuchos_LAPACK.hpp>

#include <limits>

namespace epafi::contact {

using bem::dot;

namespace {

/// D of the inactive coefficients, scaled, in the corner of a matrix of this size.
Matrix reducedMatrix(const Reduction& r, Index size) {
  Matrix m(size, size);
  for (Index q = 0; q < r.count(); ++q) {
    const double* column = r.problem.flexibility.column(r.inactive[at(q)]);
    for (Index p = 0; p < r.count(); ++p)
      m(p, q) = r.scale[at(p)] * r.scale[at(q)] * column[r.inactive[at(p)]];
  }
  return m;
}

class Dense : public Factoring {
 public:
  explicit Dense(const Reduction& reduction) : r_(reduction) {}

  Vector solve(const Vector& b) const final {
    Vector d = r_.knownChanges(b);
    const Vector x = solveReduced(rightSide(b, d));
    for (Index p = 0; p < r_.count(); ++p)
      d[at(r_.inactive[at(p)])] = r_.scale[at(p)] * x[at(p)];
    r_.follow(d);
    r_.appendMotions(x.data() + r_.count(), d);
    return d;
  }

 protected:
  /// The scaled inactive changes, then the sizes of the held motions.
  virtual Vector solveReduced(Vector x) const = 0;

  const Reduction& r_;

 private:
  // The inactive rows after the known changes d, scaled, and then the held balances.
  Vector rightSide(const Vector& b, const Vector& d) const {
    Vector x = r_.rightSides(b);
    for (Index j = 0; j < r_.n; ++j) {
      const double* column = r_.problem.flexibility.column(j);
      for (Index p = 0; p < r_.count() && d[at(j)] != 0; ++p)
        x[at(p)] -= column[r_.inactive[at(p)]] * d[at(j)];
    }
    for (Index p = 0; p < r_.count(); ++p)
      x[at(p)] *= r_.scale[at(p)];
    const Vector rest = r_.balance(b, d);
    for (Index j = 0; j < r_.held.columns(); ++j)
      x.push_back(dot(columnOf(r_.held, j), rest));
    return x;
  }
};

void factorPositive(Matrix& a, const char* name) {
  const int info = cholesky(a);
  if (info != 0)
    throw SingularJacobian(
        bem::message("singular Newton matrix: ", name,
                     " is not positive definite (pivot ", info, " of ", a.rows(),
                     "); two multiplier coefficients may act on the same displacement"));
}

// M d - Ĝ β = x, Ĝᵀ d = h  is the same as  (M + Ĝ Ĝᵀ) d - Ĝ β = x + Ĝ h, Ĝᵀ d = h.
class ByCholesky final : public Dense {
 public:
  explicit ByCholesky(const Reduction& reduction)
      : Dense(reduction),
        factor_(reducedMatrix(reduction, reduction.count())),
        solvedBorder_(reduction.border.copy()) {
    const Matrix& border = r_.border;
    for (Index j = 0; j < border.columns(); ++j)
      for (Index q = 0; q < r_.count(); ++q)
        for (Index p = 0; p < r_.count(); ++p)
          factor_(p, q) += border(p, j) * border(q, j);
    factorPositive(factor_, "the contact flexibility of the active coefficients");
    for (Index j = 0; j < border.columns(); ++j)
      choleskySolve(factor_, solvedBorder_.column(j));
    schur_ = transposedTimes(border, solvedBorder_);
    factorPositive(schur_, "the balance of the free rigid motions");
  }

 private:
  Vector solveReduced(Vector x) const override {
    const Matrix& border = r_.border;
    const Vector h(x.begin() + r_.count(), x.end());
    for (Index j = 0; j < border.columns(); ++j)
      for (Index p = 0; p < r_.count(); ++p)
        x[at(p)] += border(p, j) * h[at(j)];
    choleskySolve(factor_, x.data());
    Vector beta = h;
    for (Index j = 0; j < border.columns(); ++j)
      for (Index p = 0; p < r_.count(); ++p)
        beta[at(j)] -= border(p, j) * x[at(p)];
    choleskySolve(schur_, beta.data());
    for (Index j = 0; j < border.columns(); ++j) {
      for (Index p = 0; p < r_.count(); ++p)
        x[at(p)] += solvedBorder_(p, j) * beta[at(j)];
      x[at(r_.count() + j)] = beta[at(j)];
    }
    return x;
  }

  Matrix factor_;        // of M + Ĝ Ĝᵀ
  Matrix solvedBorder_;  // (M + Ĝ Ĝᵀ)⁻¹ Ĝ
  Matrix schur_;         // the factor of Ĝᵀ (M + Ĝ Ĝᵀ)⁻¹ Ĝ
};

class ByLu final : public Dense {
 public:
  explicit ByLu(const Reduction& reduction) : Dense(reduction) {
    Matrix m = matrix();
    equilibrate(m);
    lu_ = bem::LuFactor(std::move(m));
    const double condition = lu_.reciprocalCondition();
    if (!(condition > std::numeric_limits<double>::epsilon()))
      throw SingularJacobian(bem::message(
          "singular Newton matrix of Coulomb's problem (reciprocal condition ", condition,
          "): at this friction coefficient the solution may not be unique"));
  }

 private:
  Matrix matrix() const {
    const Index count = r_.count();
    const Index held = r_.held.columns();
    Matrix m = reducedMatrix(r_, count + held);
    for (Index j = 0; j < held; ++j)
      for (Index p = 0; p < count; ++p) {
        m(p, count + j) = -r_.border(p, j);
        m(count + j, p) = r_.border(p, j);
      }
    r_.forEachFollower([&](Index i, Index leader, double factor) {
      const Index q = r_.position[at(leader)];
      const double* column = r_.problem.flexibility.column(i);
      for (Index p = 0; p < count; ++p)
        m(p, q) +=
            r_.scale[at(p)] * r_.scale[at(q)] * factor * column[r_.inactive[at(p)]];
      for (Index j = 0; j < held; ++j)
        m(count + j, q) += r_.scale[at(q)] * factor * r_.heldEntry(i, j);
    });
    return m;
  }

  // Stiff rows stand beside soft ones.
  void equilibrate(Matrix& m) {
    const int size = static_cast<int>(m.columns());
    rowScale_.assign(at(m.columns()), 1.0);
    columnScale_ = rowScale_;
    double least = 0;
    double largest = 0;
    int info = 0;
    if (size > 0)
      Teuchos::LAPACK<int, double>().GEEQU(
          size, size, m.data(), static_cast<int>(m.stride()), rowScale_.data(),
          columnScale_.data(), &least, &least, &largest, &info);
    for (Index j = 0; j < m.columns() && info == 0; ++j)
      for (Index i = 0; i < m.rows(); ++i)
        m(i, j) *= rowScale_[at(i)] * columnScale_[at(j)];
  }

  Vector solveReduced(Vector x) const override {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] *= rowScale_[i];
    lu_.solve(x);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] *= columnScale_[i];
    return x;
  }

  bem::LuFactor lu_;
  Vector rowScale_;
  Vector columnScale_;
};

}  // namespace

std::unique_ptr<const Factoring> denseFactoring(const Reduction& reduction) {
  if (reduction.symmetric)
    return std::make_unique<const ByCholesky>(reduction);
  return std::make_unique<const ByLu>(reduction);
}

}  // namespace epafi::contact
