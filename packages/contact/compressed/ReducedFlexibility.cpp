#include "contact/compressed/ReducedFlexibility.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

using bem::axpy;

ReducedFlexibility::ReducedFlexibility(const CompressedFlexibility& whole, System system)
    : whole_(whole),
      system_(std::move(system)),
      number_(whole.nextNumber()),
      restriction_(whole.restriction()) {
  const Index first = whole.operators().further();
  for (const Index row : system_.rows)
    restriction_.held[at(first + row)] = 0;
  for (const auto& [follower, leader, factor] : system_.followers)
    restriction_.followers.push_back({first + follower, first + leader, factor});
  for (const auto& [row, column, value] : system_.added)
    restriction_.entries.push_back({first + row, first + column, -value});
  makeCorrection();
  makeBorder();
}

Matrix ReducedFlexibility::solve(Matrix b) const {
  for (Index c = 0; c < b.columns(); ++c) {
    Vector x = coefficients(b.column(c));
    Vector sizes(b.column(c) + whole_.size(), b.column(c) + b.rows());
    axpy(-1, columnOf(transposedTimes(system_.motions, bem::asColumn(x)), 0), sizes);
    border_.solve(sizes);
    for (std::size_t k = 0; k < sizes.size(); ++k)
      axpy(sizes[k], columnOf(answers_, static_cast<Index>(k)), x);
    std::copy(x.begin(), x.end(), b.column(c));
    std::copy(sizes.begin(), sizes.end(), b.column(c) + whole_.size());
  }
  return b;
}

Vector ReducedFlexibility::coefficients(const double* b) const {
  Vector right(b, b + whole_.size());
  const bem::LowRank& terms = whole_.motions();
  if (terms.u.columns() == 0)
    return solveSprung(std::move(right));
  Vector known = right;
  for (const Index row : system_.rows)
    known[at(row)] = 0;
  // b - U S Uᵀ x of the known coefficients
  Matrix ofKnown(whole_.size(), 1);
  terms.addTo(ofKnown, bem::asColumn(known));
  for (const Index row : system_.rows)
    right[at(row)] -= ofKnown(row, 0);
  Vector x = solveSprung(std::move(right));
  axpy(-1, known, x);
  Matrix own = bem::asColumn(x);
  correction_.correct(own);
  x = columnOf(own, 0);
  axpy(1, known, x);
  return x;
}

// Z y + Ĉᵀ x = 0,  Ĉ y - M x = -b  in the rows, with the known coefficients in x
Vector ReducedFlexibility::solveSprung(Vector b) const {
  const Index first = whole_.operators().further();
  Matrix right(whole_.operators().size(), 1);
  for (const Index row : system_.rows)
    right(first + row, 0) = -std::exchange(b[at(row)], 0.0);
  whole_.addTranspose(-1, b.data(), right.column(0));
  for (const auto* entries : {&whole_.mass(), &system_.added})
    for (const bem::Entry& entry : *entries)
      right(first + entry.row, 0) += entry.value * b[at(entry.column)];
  const Matrix solution = factor().solve(right);
  for (Index i = 0; i < whole_.size(); ++i)
    b[at(i)] += solution(first + i, 0);
  return b;
}

void ReducedFlexibility::makeCorrection() {
  const bem::LowRank& terms = whole_.motions();
  const Index first = whole_.operators().further();
  Matrix right(whole_.operators().size(), terms.u.columns());
  for (Index j = 0; j < right.columns(); ++j)
    for (const Index i : system_.rows)
      right(first + i, j) = -terms.u(i, j);
  const CompressedFlexibility::Along& own = factor();
  if (right.columns() == 0)
    return;
  correction_ = bem::Woodbury(terms.u.copy(), terms.inverse.copy(),
                              bem::rowsBetween(own.solve(right), first, right.rows()),
                              "the flexibility of the active coefficients");
}

void ReducedFlexibility::makeBorder() {
  const Index columns = system_.motions.columns();
  answers_ = Matrix(whole_.size(), columns);
  for (Index k = 0; k < columns; ++k) {
    Vector right(at(whole_.size()), 0.0);
    for (const Index row : system_.rows)
      right[at(row)] = system_.motions(row, k);
    right = coefficients(right.data());
    std::copy(right.begin(), right.end(), answers_.column(k));
  }
  Matrix border = transposedTimes(system_.motions, answers_);
  for (Index l = 0; l < system_.stiffness.columns(); ++l)
    for (Index k = 0; k < columns; ++k)
      border(k, l) += system_.stiffness(k, l);
  border_ = bem::LuFactor(std::move(border));
  if (!border_.isRegular())
    throw SingularJacobian("singular Newton matrix: nothing balances the rigid motions");
}

}  // namespace epafi::contact
