#include "contact/compressed/CompressedFlexibility.hpp"

#include "bem/algebra/Blas.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/Products.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

Matrix asColumn(const Vector& x) {
  Matrix column(static_cast<Index>(x.size()), 1);
  std::copy(x.begin(), x.end(), column.data());
  return column;
}

Vector rowOf(const Matrix& a, Index i) {
  Vector row;
  for (Index j = 0; j < a.columns(); ++j)
    row.push_back(a(i, j));
  return row;
}

/// Those of multipliers, which alone are held and released.
std::vector<int> furtherLeaves(const bem::CompressedOperators& operators) {
  std::vector<int> leaves;
  for (Index i = operators.further(); i < operators.size(); ++i)
    leaves.push_back(operators.leafOf(i));
  return leaves;
}

/// D_M, what D is with springs in place of A⁺, and U S Uᵀ, with which it is D:
///
///   D = D_M - G wᵀ - w Gᵀ + G κ Gᵀ,   w = Ĉ M⁻¹ c,  κ = cᵀ M⁻¹ c,  G = Ĉ R
struct MotionTerms {
  Matrix u;        ///< (G, w); empty without motions
  Matrix inverse;  ///< S⁻¹ = [0, -I; -I, -κ]

  // Uᵀ x
  Vector seen(const double* x) const {
    Vector sums;
    for (Index j = 0; j < u.columns(); ++j)
      sums.push_back(std::inner_product(u.column(j), u.column(j) + u.rows(), x, 0.0));
    return sums;
  }
  // S Uᵀ x
  Vector sizes(const double* x) const { return scaled(seen(x)); }
  // S s, S = [κ, -I; -I, 0]
  Vector scaled(const Vector& sums) const {
    const Index r = u.columns() / 2;
    Vector result(sums.size());
    for (Index j = 0; j < r; ++j) {
      result[at(j)] = -sums[at(r + j)];
      result[at(r + j)] = -sums[at(j)];
      for (Index l = 0; l < r; ++l)
        result[at(j)] -= inverse(r + j, r + l) * sums[at(l)];
    }
    return result;
  }
};

class CompressedFlexibility final : public Flexibility::Operator {
 public:
  CompressedFlexibility(
      CompressedCoupling coupling,
      const std::vector<std::shared_ptr<const CompressedHolding>>& bodies)
      : coupling_(std::move(coupling)), bodies_(bodies) {
    factorAll();
    findPaths();
    makeMotionTerms();
    measureRows();
  }

  Index size() const override { return coupling().multipliers; }

  Vector times(const Vector& x) const override {
    const Matrix columns = timesColumns(asColumn(x));
    return Vector(columns.column(0), columns.column(0) + size());
  }

  // |D| |x| from the rows' sums over each kind and its largest coefficient
  Product product(const Vector& x) const override {
    Product result{times(x), Vector(at(size()))};
    double sizes[2] = {0, 0};
    for (Index i = 0; i < size(); ++i)
      sizes[kindOf(i)] = std::max(sizes[kindOf(i)], std::abs(x[at(i)]));
    for (Index i = 0; i < size(); ++i)
      result.magnitude[at(i)] =
          std::max(std::abs(result.value[at(i)]),
                   sizes[0] * rowSums_(i, 0) + sizes[1] * rowSums_(i, 1));
    return result;
  }

  Vector diagonal() const override {
    const Vector pivots = factor_->lastPivots();
    Vector result;
    for (Index i = 0; i < size(); ++i) {
      const Vector sizes = motions_.scaled(rowOf(motions_.u, i));
      double entry = -pivots[at(coupling().first + i)];
      for (Index j = 0; j < motions_.u.columns(); ++j)
        entry += motions_.u(i, j) * sizes[at(j)];
      result.push_back(entry);
    }
    return result;
  }

  std::unique_ptr<Factor> factor(const System& system) const override;

  const CompressedCoupling& coupling() const { return coupling_; }
  const bem::CompressedOperators& operators() const {
    return bodies_.front()->operators();
  }
  /// Of all bodies, every multiplier held.
  const bem::Restriction& restriction() const { return factor_->restriction(); }
  const MotionTerms& motionTerms() const { return motions_; }
  const std::vector<char>& paths() const { return paths_; }

 private:
  friend class ReducedFlexibility;

  int kindOf(Index i) const { return i < coupling().normals ? 0 : 1; }

  // Of all bodies together, every multiplier held: what one of them asks for or leaves free.
  void factorAll() {
    if (bodies_.size() == 1) {
      factor_ = std::make_unique<bem::CompressedFactor>(bodies_.front()->factor());
      return;
    }
    bem::Restriction restriction;
    for (const auto& body : bodies_) {
      const bem::Restriction& own = body->restriction();
      restriction.held.resize(own.held.size(), 1);
      for (std::size_t i = 0; i < own.held.size(); ++i)
        restriction.held[i] = static_cast<char>(restriction.held[i] & own.held[i]);
      restriction.entries.insert(restriction.entries.end(), own.entries.begin(),
                                 own.entries.end());
    }
    factor_ = std::make_unique<bem::CompressedFactor>(operators(), std::move(restriction),
                                                      furtherLeaves(operators()));
  }

  // The leaves that the multiplier acts on.
  void findPaths() {
    std::vector<int> leaves = furtherLeaves(operators());
    for (const Coupling::Entry& entry : coupling().entries)
      leaves.push_back(operators().leafOf(entry.row));
    *factor_ = factor_->within(leaves);
    paths_ = factor_->paths(std::move(leaves));
  }

  // D X = D_M X + U S Uᵀ X
  Matrix timesColumns(const Matrix& x) const {
    Matrix forces(operators().size(), x.columns());
    for (Index j = 0; j < x.columns(); ++j)
      coupling().push(1, x.column(j), forces.column(j));
    const Matrix moved = factor_->solveAlong(paths_, forces);
    Matrix result(size(), x.columns());
    for (Index j = 0; j < x.columns(); ++j) {
      const Vector pulled = coupling().pull(moved.column(j));
      std::copy(pulled.begin(), pulled.end(), result.column(j));
      for (const Coupling::Entry& entry : coupling().mass)
        result(entry.row, j) += entry.value * x(entry.column, j);
      const Vector sizes = motions_.sizes(x.column(j));
      for (std::size_t k = 0; k < sizes.size(); ++k)
        for (Index i = 0; i < size(); ++i)
          result(i, j) += sizes[k] * motions_.u(i, static_cast<Index>(k));
    }
    return result;
  }

  // Σ_j |D_ij| over normal and tangential coefficients j, each kind in so many groups of
  // neighbours: within one the entries have one sign, but for small ones where it changes
  // and for those of the other kind beside i, so that the group's sum has their size.
  void measureRows() {
    constexpr Index groups = 16;
    const Index counts[] = {coupling().normals, size() - coupling().normals};
    Matrix ones(size(), 2 * groups);
    for (Index j = 0; j < size(); ++j) {
      const Index kind = kindOf(j);
      const Index place = kind == 0 ? j : j - counts[0];
      ones(j, groups * kind + place * groups / counts[kind]) = 1;
    }
    const Matrix images = timesColumns(ones);
    rowSums_ = Matrix(size(), 2);
    for (Index g = 0; g < 2 * groups; ++g)
      for (Index i = 0; i < size(); ++i)
        rowSums_(i, g / groups) += std::abs(images(i, g));
  }

  void makeMotionTerms();

  CompressedCoupling coupling_;
  std::vector<std::shared_ptr<const CompressedHolding>> bodies_;
  std::unique_ptr<bem::CompressedFactor> factor_;
  std::vector<char> paths_;
  MotionTerms motions_;
  Matrix rowSums_;  ///< over each kind
  /// Kept from step to step, so that only what changes is eliminated anew.
  mutable std::unique_ptr<bem::CompressedFactor> reduced_;
};

/// Some of the multiplier's coefficients in the tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  ReducedFlexibility(const CompressedFlexibility& whole, bem::CompressedFactor& factor,
                     System system)
      : whole_(whole), factor_(factor), system_(std::move(system)) {
    bem::Restriction restriction = whole.restriction();
    const Index first = whole.coupling().first;
    for (std::size_t k = 0; k < system_.rows.size(); ++k) {
      restriction.held[at(first + system_.rows[k])] = 0;
      if (system_.shifts[k] != 0)
        restriction.entries.push_back(
            {first + system_.rows[k], first + system_.rows[k], -system_.shifts[k]});
    }
    for (const System::Entry& entry : system_.entries)
      restriction.entries.push_back(
          {first + entry.row, first + entry.column, -entry.value});
    for (const System::Follower& follower : system_.followers)
      restriction.followers.push_back(
          {first + follower.follower, first + follower.leader, follower.factor});
    factor_.update(std::move(restriction));
    makeCorrection();
  }

  Vector solve(const Vector& b, const Vector& known) const override {
    Vector x = solveSprung(withoutMotions(b, known), known);
    if (whole_.motionTerms().u.columns() == 0)
      return x;
    // D_M x = b - U S Uᵀ x  by Woodbury's formula
    Vector sizes = whole_.motionTerms().seen(difference(x, known).data());
    solveCorrection(sizes);
    for (std::size_t j = 0; j < sizes.size(); ++j)
      axpy(-sizes[j], columnOf(solved_, static_cast<Index>(j)), x);
    return x;
  }

 private:
  // b less what U S Uᵀ makes of the known coefficients
  Vector withoutMotions(Vector b, const Vector& known) const {
    const MotionTerms& terms = whole_.motionTerms();
    const Vector sizes = terms.sizes(known.data());
    for (std::size_t k = 0; k < b.size(); ++k)
      for (std::size_t j = 0; j < sizes.size(); ++j)
        b[k] -= terms.u(system_.rows[k], static_cast<Index>(j)) * sizes[j];
    return b;
  }

  static Vector difference(Vector a, const Vector& b) {
    axpy(-1, b, a);
    return a;
  }

  // Z y + Ĉᵀ x = 0,  Ĉ y - M x - shift x = -b  in the rows, with the known coefficients in x
  Vector solveSprung(const Vector& b, const Vector& known) const {
    const CompressedCoupling& coupling = whole_.coupling();
    Matrix right(whole_.operators().size(), 1);
    coupling.push(-1, known.data(), right.column(0));
    for (const Coupling::Entry& entry : coupling.mass)
      right(coupling.first + entry.row, 0) += entry.value * known[at(entry.column)];
    for (std::size_t k = 0; k < b.size(); ++k)
      right(coupling.first + system_.rows[k], 0) -= b[k];
    const Matrix solution = factor_.solveAlong(whole_.paths(), right);
    Vector x = known;
    for (Index i = 0; i < coupling.multipliers; ++i)
      x[at(i)] += solution(coupling.first + i, 0);
    return x;
  }

  void makeCorrection() {
    const MotionTerms& terms = whole_.motionTerms();
    const Index columns = terms.u.columns();
    const Index first = whole_.coupling().first;
    Matrix right(whole_.operators().size(), columns);
    for (Index j = 0; j < columns; ++j)
      for (const Index i : system_.rows)
        right(first + i, j) = -terms.u(i, j);
    const Matrix answers =
        columns > 0 ? factor_.solveAlong(whole_.paths(), right) : Matrix();
    solved_ = Matrix(whole_.size(), columns);
    correction_ = terms.inverse.copy();
    for (Index j = 0; j < columns; ++j) {
      std::copy_n(answers.column(j) + first, whole_.size(), solved_.column(j));
      const Vector sums = terms.seen(solved_.column(j));
      for (Index i = 0; i < columns; ++i)
        correction_(i, j) += sums[at(i)];
    }
    pivots_.resize(at(columns));
    const int n = static_cast<int>(columns);
    const int lda = static_cast<int>(correction_.stride());
    int info = 0;
    if (n > 0)
      dgetrf_(&n, &n, correction_.data(), &lda, pivots_.data(), &info);
    if (info != 0)
      throw bem::NumericalError("the flexibility of the active coefficients is singular");
  }

  void solveCorrection(Vector& sizes) const {
    const int n = static_cast<int>(sizes.size());
    const int one = 1;
    const int lda = static_cast<int>(correction_.stride());
    int info = 0;
    dgetrs_("N", &n, &one, correction_.data(), &lda, pivots_.data(), sizes.data(), &n,
            &info);
  }

  const CompressedFlexibility& whole_;
  bem::CompressedFactor& factor_;
  System system_;
  Matrix solved_;      ///< D_M⁻¹ U, all coefficients
  Matrix correction_;  ///< LU of S⁻¹ + Uᵀ D_M⁻¹ U
  std::vector<int> pivots_;
};

void CompressedFlexibility::makeMotionTerms() {
  Index r = 0;
  for (const auto& body : bodies_)
    r += body->motions();
  if (r == 0)
    return;
  motions_.u = Matrix(size(), 2 * r);
  motions_.inverse = Matrix(2 * r, 2 * r);
  Index first = 0;  // of the body's
  for (const auto& body : bodies_) {
    const Index count = body->motions();
    Matrix forces(operators().size(), count);
    for (Index k = 0; k < count; ++k) {
      const Vector c = body->functional(k);
      std::copy(c.begin(), c.end(), forces.column(k));
    }
    const Matrix answers = body->factor().solve(forces);
    for (Index k = 0; k < count; ++k) {
      const Vector g = coupling().pull(body->motion(k).data());
      const Vector w = coupling().pull(answers.column(k));
      std::copy(g.begin(), g.end(), motions_.u.column(first + k));
      std::copy(w.begin(), w.end(), motions_.u.column(r + first + k));
      motions_.inverse(first + k, r + first + k) = -1;
      motions_.inverse(r + first + k, first + k) = -1;
      for (Index l = 0; l < count; ++l)
        for (Index i = 0; i < forces.rows(); ++i)
          motions_.inverse(r + first + l, r + first + k) -= forces(i, l) * answers(i, k);
    }
    first += count;
  }
}

std::unique_ptr<Flexibility::Operator::Factor> CompressedFlexibility::factor(
    const System& system) const {
  if (reduced_ == nullptr)
    reduced_ = std::make_unique<bem::CompressedFactor>(*factor_);
  try {
    return std::make_unique<ReducedFlexibility>(*this, *reduced_, system);
  } catch (const bem::NumericalError&) {
    reduced_ = nullptr;  // half eliminated
    throw;
  }
}

}  // namespace

void CompressedCoupling::push(double s, const double* multiplier, double* x) const {
  for (const Coupling::Entry& entry : entries)
    x[entry.row] += s * entry.value * multiplier[entry.column];
  for (const Rest& rest : rests) {
    const Vector& q = rest.rotation->functional();
    const double work =
        s * std::inner_product(rest.values.begin(), rest.values.end(), multiplier, 0.0);
    for (std::size_t j = 0; j < q.size(); ++j)
      x[rest.first + static_cast<Index>(j)] += work * q[j];
  }
}

Vector CompressedCoupling::pull(const double* x) const {
  Vector result(at(multipliers));
  for (const Coupling::Entry& entry : entries)
    result[at(entry.column)] += entry.value * x[entry.row];
  for (const Rest& rest : rests) {
    const Vector& q = rest.rotation->functional();
    axpy(std::inner_product(q.begin(), q.end(), x + rest.first, 0.0), rest.values,
         result);
  }
  return result;
}

CompressedHolding::CompressedHolding(const bem::CompressedOperators& operators,
                                     std::size_t body, const Holding& holding)
    : operators_(operators), holding_(holding), range_(operators.range(body)) {
  restriction_.held.assign(at(operators.size()), 1);
  const auto held = restriction_.held.begin();
  std::fill(held + range_.densities, held + range_.last, 0);
  std::copy(holding.loads.clamped.begin(), holding.loads.clamped.end(),
            held + range_.first);
  addSprings();
  // of several bodies another factor changes
  const bool changes = operators.bodies() == 1;
  factor_ = std::make_unique<const bem::CompressedFactor>(
      operators, restriction_, changes ? furtherLeaves(operators) : std::vector<int>());
}

Vector CompressedHolding::placed(const Matrix& columns, Index k) const {
  Vector result(at(operators_.size()));
  std::copy_n(columns.column(k), columns.rows(), result.begin() + range_.first);
  return result;
}

// One for each motion that clamps leave, where it moves most against those before: pivots
// of the motions' rows.
void CompressedHolding::addSprings() {
  Matrix motions = holding_.rigid.allowed.copy();
  for (Index k = 0; k < motions.columns(); ++k) {
    Index row = 0;
    Index column = k;
    for (Index l = k; l < motions.columns(); ++l)
      for (Index i = 0; i < motions.rows(); ++i)
        if (std::abs(motions(i, l)) > std::abs(motions(row, column))) {
          row = i;
          column = l;
        }
    for (Index i = 0; i < motions.rows(); ++i)
      std::swap(motions(i, k), motions(i, column));
    restriction_.entries.push_back(
        {range_.first + row, range_.first + row, range_.young});
    for (Index l = k + 1; l < motions.columns(); ++l) {
      const double factor = motions(row, l) / motions(row, k);
      for (Index i = 0; i < motions.rows(); ++i)
        motions(i, l) -= factor * motions(i, k);
    }
  }
}

// A⁺ f = (I - R cᵀ) M⁻¹ (I - c Rᵀ) f: balanced loads do not feel springs that are as many
// as the motions
Matrix CompressedHolding::displaced(Matrix forces) const {
  const RigidConstraints& rigid = holding_.rigid;
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
  subtract(rigid.allowed, rigid.functionals, forces);
  Matrix x = factor_->solve(forces);
  subtract(rigid.functionals, rigid.allowed, x);
  return x;
}

std::shared_ptr<const Flexibility::Operator> compressedFlexibility(
    CompressedCoupling coupling,
    std::vector<std::shared_ptr<const CompressedHolding>> bodies) {
  return std::make_shared<const CompressedFlexibility>(std::move(coupling),
                                                       std::move(bodies));
}

}  // namespace epafi::contact
