#include "contact/compressed/ReducedFlexibility.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>

namespace epafi::contact {

using bem::axpy;

namespace {

Vector difference(Vector a, const Vector& b) {
  axpy(-1, b, a);
  return a;
}

}  // namespace

ReducedFlexibility::ReducedFlexibility(const CompressedFlexibility& whole, System system)
    : whole_(whole),
      system_(std::move(system)),
      number_(whole.nextNumber()),
      restriction_(whole.restriction()) {
  const Index first = whole.coupling().first;
  for (const Index row : system_.rows)
    restriction_.held[at(first + row)] = 0;
  for (const auto& [follower, leader, factor] : system_.followers)
    restriction_.followers.push_back({first + follower, first + leader, factor});
  makeCorrection();
}

Vector ReducedFlexibility::solve(const Vector& b, const Vector& known) const {
  Vector x = solveSprung(withoutMotions(b, known), known);
  if (whole_.motionTerms().u.columns() == 0)
    return x;
  // D_M x = b - U S Uᵀ x  by Woodbury's formula
  Vector sizes = whole_.motionTerms().seen(difference(x, known).data());
  correction_.solve(sizes);
  for (std::size_t j = 0; j < sizes.size(); ++j)
    axpy(-sizes[j], columnOf(solved_, static_cast<Index>(j)), x);
  return x;
}

// b less what U S Uᵀ makes of the known coefficients
Vector ReducedFlexibility::withoutMotions(Vector b, const Vector& known) const {
  const MotionTerms& terms = whole_.motionTerms();
  const Vector sizes = terms.sizes(known.data());
  for (std::size_t k = 0; k < b.size(); ++k)
    for (std::size_t j = 0; j < sizes.size(); ++j)
      b[k] -= terms.u(system_.rows[k], static_cast<Index>(j)) * sizes[j];
  return b;
}

// Z y + Ĉᵀ x = 0,  Ĉ y - M x = -b  in the rows, with the known coefficients in x
Vector ReducedFlexibility::solveSprung(const Vector& b, const Vector& known) const {
  const CompressedCoupling& coupling = whole_.coupling();
  Matrix right(whole_.operators().size(), 1);
  coupling.push(-1, known.data(), right.column(0));
  for (const bem::Entry& entry : coupling.mass)
    right(coupling.first + entry.row, 0) += entry.value * known[at(entry.column)];
  for (std::size_t k = 0; k < b.size(); ++k)
    right(coupling.first + system_.rows[k], 0) -= b[k];
  const Matrix solution = factor().solveAlong(whole_.paths(), right);
  Vector x = known;
  for (Index i = 0; i < coupling.multipliers; ++i)
    x[at(i)] += solution(coupling.first + i, 0);
  return x;
}

void ReducedFlexibility::makeCorrection() {
  const MotionTerms& terms = whole_.motionTerms();
  const Index columns = terms.u.columns();
  const Index first = whole_.coupling().first;
  Matrix right(whole_.operators().size(), columns);
  for (Index j = 0; j < columns; ++j)
    for (const Index i : system_.rows)
      right(first + i, j) = -terms.u(i, j);
  const bem::CompressedFactor& own = factor();
  const Matrix answers = columns > 0 ? own.solveAlong(whole_.paths(), right) : Matrix();
  solved_ = Matrix(whole_.size(), columns);
  Matrix correction = terms.inverse.copy();
  for (Index j = 0; j < columns; ++j) {
    std::copy_n(answers.column(j) + first, whole_.size(), solved_.column(j));
    const Vector sums = terms.seen(solved_.column(j));
    for (Index i = 0; i < columns; ++i)
      correction(i, j) += sums[at(i)];
  }
  correction_ = bem::LuFactor(std::move(correction));
  if (!correction_.isRegular())
    throw bem::NumericalError("the flexibility of the active coefficients is singular");
}

}  // namespace epafi::contact
