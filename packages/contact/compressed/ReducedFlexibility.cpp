#include "contact/compressed/ReducedFlexibility.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

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
  // one pass through the tree for all columns
  const bem::LowRank& terms = whole_.motions();
  const Index corrected = terms.u.columns();
  const Index motions = system_.motions.columns();
  Matrix columns(whole_.size(), corrected + motions);
  for (Index j = 0; j < columns.columns(); ++j)
    for (const Index row : system_.rows)
      columns(row, j) =
          j < corrected ? terms.u(row, j) : system_.motions(row, j - corrected);
  columns = solveSprung(std::move(columns));
  answers_ = bem::columnsBetween(columns, corrected, corrected + motions);
  columns.shrink(corrected);
  makeCorrection(std::move(columns));
  makeBorder();
}

Matrix ReducedFlexibility::solve(Matrix b) const {
  Matrix x = coefficients(bem::rowsBetween(b, 0, whole_.size()));
  Matrix sizes = bem::rowsBetween(b, whole_.size(), b.rows());
  addTransposedProduct(-1, system_.motions, x, sizes);
  border_.solve(sizes);
  addProduct(1, answers_, sizes, x);
  return stacked(x, sizes);
}

Matrix ReducedFlexibility::coefficients(Matrix b) const {
  const bem::LowRank& terms = whole_.motions();
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
Matrix ReducedFlexibility::solveSprung(Matrix b) const {
  const Index first = whole_.operators().further();
  Matrix right(whole_.operators().size(), b.columns());
  for (Index c = 0; c < b.columns(); ++c) {
    for (const Index row : system_.rows)
      right(first + row, c) = -std::exchange(b(row, c), 0.0);
    whole_.addTranspose(-1, b.column(c), right.column(c));
    for (const auto* entries : {&whole_.mass(), &system_.added})
      for (const bem::Entry& entry : *entries)
        right(first + entry.row, c) += entry.value * b(entry.column, c);
  }
  const Matrix solution = factor().solve(right);
  for (Index c = 0; c < b.columns(); ++c)
    for (Index i = 0; i < b.rows(); ++i)
      b(i, c) += solution(first + i, c);
  return b;
}

void ReducedFlexibility::makeCorrection(Matrix answers) {
  const bem::LowRank& terms = whole_.motions();
  if (answers.columns() == 0)
    return;
  correction_ = bem::Woodbury(terms.u.copy(), terms.inverse.copy(), std::move(answers),
                              "the flexibility of the active coefficients");
  correction_.correct(answers_);
}

void ReducedFlexibility::makeBorder() {
  Matrix border = transposedTimes(system_.motions, answers_);
  for (Index l = 0; l < system_.stiffness.columns(); ++l)
    for (Index k = 0; k < border.rows(); ++k)
      border(k, l) += system_.stiffness(k, l);
  border_ = bem::LuFactor(std::move(border));
  if (!border_.isRegular())
    throw SingularJacobian("singular Newton matrix: nothing balances the rigid motions");
}

}  // namespace epafi::contact
