#include "contact/compressed/CompressedFlexibility.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace epafi::contact {

class CompressedFlexibility::Reduced final : public Factor {
 public:
  /// Refers to `whole`.  \throws bem::NumericalError if singular, as solve() does
  Reduced(const CompressedFlexibility& whole, System system);

  /// Rigid motions by their Schur complement Ĝᵀ D⁻¹ Ĝ + K̂.
  Matrix solve(Matrix b) const override;

 private:
  /// x for right-hand sides b (columns), with β = 0.
  Matrix coefficients(Matrix b) const;
  /// The same with D_M, see motions_.
  Matrix solveSprung(Matrix b) const;
  /// From D_M⁻¹ U in the rows.
  void makeCorrection(Matrix answers);
  void makeBorder();
  const Along& factor() const { return whole_.eliminated(number_, restriction_); }

  const CompressedFlexibility& whole_;
  System system_;
  int number_;
  bem::Restriction restriction_;
  bem::Woodbury correction_;  ///< from D_M⁻¹ to D⁻¹ in the rows
  Matrix answers_;            ///< x for b = Ĝ: D⁻¹ Ĝ
  bem::LuFactor border_;      ///< of the Schur complement
};

CompressedFlexibility::CompressedFlexibility(
    std::vector<std::shared_ptr<const CompressedBody>> bodies, Index normals,
    const std::vector<std::vector<Vector>>& reactions, const std::vector<Index>& columns)
    : bodies_(std::move(bodies)), normals_(normals) {
  takeCoupling(columns);
  restrictAll();
  if (bodies_.size() == 1)
    own_.push_back(along(bodies_.front()->factor()));
  else  // what is asked of one of them all the time is narrowed, see eliminated
    for (const auto& body : bodies_)
      own_.push_back({body->factor(), body->factor().activePaths(leaves_)});
  addMotions(reactions, columns);
}

// Of the entries that Z has beside the boundary operators, by places of columns.
void CompressedFlexibility::takeCoupling(const std::vector<Index>& columns) {
  std::vector<Index> places(bodies_.front()->coupling().trace.rests.size(), -1);
  for (std::size_t k = 0; k < columns.size(); ++k)
    places[at(columns[k])] = static_cast<Index>(k);
  for (const auto& body : bodies_) {
    const Coupling& own = body->coupling();
    coupling_.push_back(own.withDensities(body->space().displacements()));
    mass_.insert(mass_.end(), own.mass.begin(), own.mass.end());
    if (columns.empty())
      continue;
    for (bem::Entry& entry : coupling_.back().entries)
      entry.column = places[at(entry.column)];
    coupling_.back().rests = entriesAt(columns, coupling_.back().rests);
  }
  for (bem::Entry& entry : mass_)
    if (!columns.empty())
      entry = {places[at(entry.row)], places[at(entry.column)], entry.value};
}

void CompressedFlexibility::addTranspose(double s, const double* multiplier,
                                         double* x) const {
  for (std::size_t b = 0; b < coupling_.size(); ++b)
    coupling_[b].addTranspose(s, multiplier, x + operators().range(b).first);
}

Vector CompressedFlexibility::apply(const double* x) const {
  Vector result(at(size()));
  for (std::size_t b = 0; b < coupling_.size(); ++b)
    coupling_[b].addApplied(x + operators().range(b).first, result);
  return result;
}

Vector CompressedFlexibility::times(const Vector& x) const {
  const Matrix columns = timesColumns(bem::ConstMatrixView(x).copy());
  return Vector(columns.column(0), columns.column(0) + size());
}

Flexibility::Operator::Product CompressedFlexibility::product(const Vector& x) const {
  if (rowSums_.empty())
    measureRows();
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

// Of all bodies together, every multiplier held: what one of them asks for or leaves free.
void CompressedFlexibility::restrictAll() {
  restriction_ = bodies_.front()->restriction();
  for (std::size_t b = 1; b < bodies_.size(); ++b) {
    const bem::Restriction& own = bodies_[b]->restriction();
    std::transform(own.held.begin(), own.held.end(), restriction_.held.begin(),
                   restriction_.held.begin(),
                   [](char a, char other) { return static_cast<char>(a & other); });
    restriction_.entries.insert(restriction_.entries.end(), own.entries.begin(),
                                own.entries.end());
  }
  // with multipliers, the only unknowns that become held or free between steps
  for (Index i = operators().further(); i < operators().size(); ++i)
    leaves_.push_back(operators().leafOf(i));
  for (std::size_t b = 0; b < coupling_.size(); ++b)
    for (const bem::Entry& entry : coupling_[b].entries)
      leaves_.push_back(operators().leafOf(operators().range(b).first + entry.row));
}

CompressedFlexibility::Along CompressedFlexibility::along(
    const bem::CompressedFactor& factor) const {
  bem::CompressedFactor narrow = factor.restrictedTo(leaves_);
  std::vector<char> paths = narrow.activePaths(leaves_);
  return {std::move(narrow), std::move(paths)};
}

void CompressedFlexibility::addMotions(const std::vector<std::vector<Vector>>& reactions,
                                       const std::vector<Index>& columns) {
  Index count = 0;
  for (const auto& body : bodies_)
    count += body->motions().columns();
  Matrix u(size(), 2 * count);
  Matrix kappa(count, count);
  Index first = 0;  // of the body's
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto& body = bodies_[b];
    const Matrix moved = body->motions();
    const Matrix forces = body->functionals();
    const Index own = moved.columns();
    const Matrix answers = own > 0 ? body->factor().solve(forces) : Matrix();
    for (Index k = 0; k < own; ++k) {
      const Vector g = apply(moved.column(k));
      Vector w = apply(answers.column(k));
      if (b < reactions.size() && at(k) < reactions[b].size())
        bem::axpy(1,
                  columns.empty() ? reactions[b][at(k)]
                                  : entriesAt(columns, reactions[b][at(k)]),
                  w);
      std::copy(g.begin(), g.end(), u.column(first + k));
      std::copy(w.begin(), w.end(), u.column(count + first + k));
      for (Index l = 0; l < own; ++l)
        kappa(first + l, first + k) = bem::dot(columnOf(forces, l), columnOf(answers, k));
    }
    first += own;
  }
  motions_ = bem::LowRank(std::move(u), kappa);
}

// D X = D_M X + U S Uᵀ X
Matrix CompressedFlexibility::timesColumns(const Matrix& x) const {
  Matrix forces(operators().size(), x.columns());
  const bem::Job job{
      x.columns(),
      bem::workOfNumbers(10 * static_cast<double>(operators().size() * x.columns()))};
  bem::parallelFor(job, [&](Index j) { addTranspose(1, x.column(j), forces.column(j)); });
  // a multiplier that is held ties no bodies to one another
  Matrix moved = own_.front().solve(forces);
  for (std::size_t b = 1; b < own_.size(); ++b)
    bem::addTo(moved, own_[b].solve(forces));
  Matrix result(size(), x.columns());
  bem::parallelFor(job, [&](Index j) {
    const Vector applied = apply(moved.column(j));
    std::copy(applied.begin(), applied.end(), result.column(j));
    for (const bem::Entry& entry : mass_)
      result(entry.row, j) += entry.value * x(entry.column, j);
  });
  motions_.addTo(result, x);
  return result;
}

// Σ_j |D_ij| over normal and tangential coefficients j, each kind in so many groups of
// neighbours: within one the entries have one sign, but for small ones where it changes and
// for those of the other kind beside i, so that the group's sum has their size.
void CompressedFlexibility::measureRows() const {
  constexpr Index groups = 16;
  const Index counts[] = {normals_, size() - normals_};
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

Matrix CompressedFlexibility::formed() const {
  constexpr Index atOnce = 128;
  Matrix result(size(), size());
  for (Index first = 0; first < size(); first += atOnce) {
    const Index last = std::min(first + atOnce, size());
    Matrix units(size(), last - first);
    for (Index j = first; j < last; ++j)
      units(j, j - first) = 1;
    const Matrix columns = timesColumns(units);
    for (Index j = first; j < last; ++j)
      std::copy_n(columns.column(j - first), size(), result.column(j));
  }
  for (Index j = 0; j < size(); ++j)
    for (Index i = 0; i < j; ++i)
      result(i, j) = result(j, i) = 0.5 * (result(i, j) + result(j, i));
  return result;
}

std::unique_ptr<Flexibility::Operator::Factor> CompressedFlexibility::factor(
    System system) const {
  return std::make_unique<Reduced>(*this, std::move(system));
}

const CompressedFlexibility::Along& CompressedFlexibility::eliminated(
    int number, const bem::Restriction& restriction) const {
  if (number == eliminated_)
    return *reduced_;
  // belongs to no system while update() may throw
  auto reduced = std::move(reduced_);
  release();
  if (reduced == nullptr)
    reduced = std::make_unique<Along>(
        own_.size() == 1 ? own_.front()
                         : along(bem::CompressedFactor(operators(), restriction_)));
  reduced->factor.update(restriction);
  reduced_ = std::move(reduced);
  eliminated_ = number;
  return *reduced_;
}

void CompressedFlexibility::release() const {
  reduced_ = nullptr;
  eliminated_ = 0;
}

CompressedFlexibility::Reduced::Reduced(const CompressedFlexibility& whole, System system)
    : whole_(whole),
      system_(std::move(system)),
      number_(++whole.numbers_),
      restriction_(whole.restriction_) {
  const Index first = whole.operators().further();
  for (const Index row : system_.rows)
    restriction_.held[at(first + row)] = 0;
  for (const auto& [follower, leader, factor] : system_.followers)
    restriction_.followers.push_back({first + follower, first + leader, factor});
  for (const auto& [row, column, value] : system_.added)
    restriction_.entries.push_back({first + row, first + column, -value});
  // one pass through the tree for all columns
  const bem::LowRank& terms = whole_.motions_;
  const Index corrected = terms.u.columns();
  const Index motions = system_.motions.columns();
  Matrix columns(whole_.size(), corrected + motions);
  for (Index j = 0; j < columns.columns(); ++j)
    for (const Index row : system_.rows)
      columns(row, j) =
          j < corrected ? terms.u(row, j) : system_.motions(row, j - corrected);
  columns = solveSprung(std::move(columns));
  answers_ = bem::columnsBetween(columns, corrected, corrected + motions).copy();
  columns.shrink(corrected);
  makeCorrection(std::move(columns));
  makeBorder();
}

Matrix CompressedFlexibility::Reduced::solve(Matrix b) const {
  Matrix x = coefficients(bem::rowsBetween(b, 0, whole_.size()).copy());
  Matrix sizes = bem::rowsBetween(b, whole_.size(), b.rows()).copy();
  addTransposedProduct(-1, system_.motions, x, sizes);
  border_.solve(sizes);
  addProduct(1, answers_, sizes, x);
  return stacked(x, sizes);
}

Matrix CompressedFlexibility::Reduced::coefficients(Matrix b) const {
  const bem::LowRank& terms = whole_.motions_;
  if (terms.u.columns() == 0)
    return solveSprung(std::move(b));
  Matrix known = b.copy();
  for (Index c = 0; c < b.columns(); ++c)
    for (const Index row : system_.rows)
      known(row, c) = 0;
  // b - U S Uᵀ x of the known coefficients
  Matrix ofKnown(b.rows(), b.columns());
  terms.addTo(ofKnown, known);
  for (Index c = 0; c < b.columns(); ++c)
    for (const Index row : system_.rows)
      b(row, c) -= ofKnown(row, c);
  Matrix x = solveSprung(std::move(b));
  for (Index c = 0; c < x.columns(); ++c)
    for (Index i = 0; i < x.rows(); ++i)
      x(i, c) -= known(i, c);
  correction_.correct(x);
  addTo(x, known);
  return x;
}

// Z y + Ĉᵀ x = 0,  Ĉ y - M x = -b  in the rows, with the known coefficients in x
Matrix CompressedFlexibility::Reduced::solveSprung(Matrix b) const {
  const Index first = whole_.operators().further();
  Matrix right(whole_.operators().size(), b.columns());
  for (Index c = 0; c < b.columns(); ++c) {
    for (const Index row : system_.rows)
      right(first + row, c) = -std::exchange(b(row, c), 0.0);
    whole_.addTranspose(-1, b.column(c), right.column(c));
    for (const auto* entries : {&whole_.mass_, &system_.added})
      for (const bem::Entry& entry : *entries)
        right(first + entry.row, c) += entry.value * b(entry.column, c);
  }
  const Matrix solution = factor().solve(right);
  for (Index c = 0; c < b.columns(); ++c)
    for (Index i = 0; i < b.rows(); ++i)
      b(i, c) += solution(first + i, c);
  return b;
}

void CompressedFlexibility::Reduced::makeCorrection(Matrix answers) {
  const bem::LowRank& terms = whole_.motions_;
  if (answers.columns() == 0)
    return;
  correction_ = bem::Woodbury(terms.u.copy(), terms.inverse.copy(), std::move(answers),
                              "the flexibility of the active coefficients");
  correction_.correct(answers_);
}

void CompressedFlexibility::Reduced::makeBorder() {
  Matrix border = transposedProduct(system_.motions, answers_);
  for (Index l = 0; l < system_.stiffness.columns(); ++l)
    for (Index k = 0; k < border.rows(); ++k)
      border(k, l) += system_.stiffness(k, l);
  border_ = bem::LuFactor(std::move(border));
  if (!border_.isRegular())
    throw SingularJacobian("singular Newton matrix: nothing balances the rigid motions");
}

}  // namespace epafi::contact
