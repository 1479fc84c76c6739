#include "contact/compressed/CompressedFlexibility.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/compressed/ReducedFlexibility.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace epafi::contact {

CompressedFlexibility::CompressedFlexibility(
    CompressedCoupling coupling,
    std::vector<std::shared_ptr<const CompressedHolding>> bodies)
    : coupling_(std::move(coupling)), bodies_(std::move(bodies)) {
  factorAll();
  findPaths();
  addMotions();
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

// Factor of all bodies, all multipliers held: free are the unknowns that one body has free.
void CompressedFlexibility::factorAll() {
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

// The leaves coupled to the multiplier.
void CompressedFlexibility::findPaths() {
  std::vector<int> leaves = furtherLeaves(operators());
  for (const bem::Entry& entry : coupling_.entries)
    leaves.push_back(operators().leafOf(entry.row));
  *factor_ = factor_->within(leaves);
  paths_ = factor_->paths(std::move(leaves));
}

void CompressedFlexibility::addMotions() {
  Index count = 0;
  for (const auto& body : bodies_)
    count += body->motions().columns();
  Matrix u(size(), 2 * count);
  Matrix kappa(count, count);
  Index first = 0;  // column of the body's first motion
  for (const auto& body : bodies_) {
    const Matrix moved = body->motions();
    const Matrix forces = body->functionals();
    const Index own = moved.columns();
    const Matrix answers = own > 0 ? body->factor().solve(forces) : Matrix();
    for (Index k = 0; k < own; ++k) {
      const Vector g = coupling_.pull(moved.column(k));
      const Vector w = coupling_.pull(answers.column(k));
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
    coupling_.push(1, x.column(j), forces.column(j));
  const Matrix moved = factor_->solveAlong(paths_, forces);
  Matrix result(size(), x.columns());
  for (Index j = 0; j < x.columns(); ++j) {
    const Vector pulled = coupling_.pull(moved.column(j));
    std::copy(pulled.begin(), pulled.end(), result.column(j));
    for (const bem::Entry& entry : coupling_.mass)
      result(entry.row, j) += entry.value * x(entry.column, j);
  }
  motions_.addTo(result, x);
  return result;
}

// Estimates Σ_j |D_ij| over normal and over tangential j by Σ_g |Σ_{j in g} D_ij|, g: 16
// groups of neighbours.  Within a group entries mostly have one sign.
void CompressedFlexibility::measureRows() const {
  constexpr Index groups = 16;
  const Index counts[] = {coupling_.normals, size() - coupling_.normals};
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

const bem::CompressedFactor& CompressedFlexibility::eliminated(
    int number, const bem::Restriction& restriction) const {
  if (number == eliminated_)
    return *reduced_;
  // belongs to no system while update() may throw
  auto reduced = reduced_ == nullptr ? std::make_unique<bem::CompressedFactor>(*factor_)
                                     : std::move(reduced_);
  release();
  reduced->update(restriction);
  reduced_ = std::move(reduced);
  eliminated_ = number;
  return *reduced_;
}

void CompressedFlexibility::release() const {
  reduced_ = nullptr;
  eliminated_ = 0;
}

}  // namespace epafi::contact
