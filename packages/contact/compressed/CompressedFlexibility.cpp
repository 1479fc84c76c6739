#include "contact/compressed/CompressedFlexibility.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/compressed/ReducedFlexibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace epafi::contact {

CompressedFlexibility::CompressedFlexibility(
    std::vector<std::shared_ptr<const CompressedBody>> bodies, Index normals)
    : bodies_(std::move(bodies)), normals_(normals) {
  takeCoupling();
  restrictAll();
  if (bodies_.size() == 1)
    own_.push_back(along(bodies_.front()->factor()));
  else  // what is asked of one of them all the time is narrowed, see eliminated
    for (const auto& body : bodies_)
      own_.push_back({body->factor(), body->factor().activePaths(leaves_)});
  addMotions();
}

// Of the entries that Z has beside the boundary operators.
void CompressedFlexibility::takeCoupling() {
  const Index first = operators().further();
  for (const auto& [row, column, value] : operators().local().entries)
    if (row >= first) {
      mass_.push_back({row - first, column - first, -value});
      if (row != column)
        mass_.push_back({column - first, row - first, -value});
    } else if (column >= first) {
      entries_.push_back({row, column - first, value});
    }
}

void CompressedFlexibility::addTranspose(double s, const double* multiplier,
                                         double* x) const {
  for (const bem::Entry& entry : entries_)
    x[entry.row] += s * entry.value * multiplier[entry.column];
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (const auto& rotation = bodies_[b]->space().rotation()) {
      const Vector& rests = operators().local().rotations[b];
      const Vector& q = rotation->functional();
      const double work =
          s * std::inner_product(rests.begin(), rests.end(), multiplier, 0.0);
      for (std::size_t j = 0; j < q.size(); ++j)
        x[operators().range(b).first + static_cast<Index>(j)] += work * q[j];
    }
}

Vector CompressedFlexibility::apply(const double* x) const {
  Vector result(at(size()));
  for (const bem::Entry& entry : entries_)
    result[at(entry.column)] += entry.value * x[entry.row];
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (const auto& rotation = bodies_[b]->space().rotation()) {
      const Vector& q = rotation->functional();
      bem::axpy(
          std::inner_product(q.begin(), q.end(), x + operators().range(b).first, 0.0),
          operators().local().rotations[b], result);
    }
  return result;
}

Vector CompressedFlexibility::times(const Vector& x) const {
  const Matrix columns = timesColumns(bem::asColumn(x));
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
  leaves_ = furtherLeaves(operators());
  for (const bem::Entry& entry : entries_)
    leaves_.push_back(operators().leafOf(entry.row));
}

CompressedFlexibility::Along CompressedFlexibility::along(
    const bem::CompressedFactor& factor) const {
  bem::CompressedFactor narrow = factor.restrictedTo(leaves_);
  std::vector<char> paths = narrow.activePaths(leaves_);
  return {std::move(narrow), std::move(paths)};
}

void CompressedFlexibility::addMotions() {
  Index count = 0;
  for (const auto& body : bodies_)
    count += body->motions().columns();
  Matrix u(size(), 2 * count);
  Matrix kappa(count, count);
  Index first = 0;  // of the body's
  for (const auto& body : bodies_) {
    const Matrix moved = body->motions();
    const Matrix forces = body->functionals();
    const Index own = moved.columns();
    const Matrix answers = own > 0 ? body->factor().solve(forces) : Matrix();
    for (Index k = 0; k < own; ++k) {
      const Vector g = apply(moved.column(k));
      const Vector w = apply(answers.column(k));
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
  for (Index j = 0; j < x.columns(); ++j)
    addTranspose(1, x.column(j), forces.column(j));
  // a multiplier that is held ties no bodies to one another
  Matrix moved = own_.front().solve(forces);
  for (std::size_t b = 1; b < own_.size(); ++b)
    bem::addTo(moved, own_[b].solve(forces));
  Matrix result(size(), x.columns());
  for (Index j = 0; j < x.columns(); ++j) {
    const Vector applied = apply(moved.column(j));
    std::copy(applied.begin(), applied.end(), result.column(j));
    for (const bem::Entry& entry : mass_)
      result(entry.row, j) += entry.value * x(entry.column, j);
  }
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
  return std::make_unique<ReducedFlexibility>(*this, std::move(system));
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
                         : along(bem::CompressedFactor(operators(), restriction_,
                                                       furtherLeaves(operators()))));
  reduced->factor.update(restriction);
  reduced_ = std::move(reduced);
  eliminated_ = number;
  return *reduced_;
}

void CompressedFlexibility::release() const {
  reduced_ = nullptr;
  eliminated_ = 0;
}

}  // namespace epafi::contact
