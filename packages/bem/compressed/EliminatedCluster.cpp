#include "bem/compressed/EliminatedCluster.hpp"

#include "bem/algebra/Products.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

namespace {

void addIdentity(Matrix& a) {
  for (Index i = 0; i < a.rows(); ++i)
    a(i, i) += 1;
}

/// A matrix in some rows and columns.
Matrix between(const Matrix& a, const std::vector<Index>& rows,
               const std::vector<Index>& columns) {
  Matrix result =
      Matrix::unset(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const double* column = a.column(columns[j]);
    for (std::size_t i = 0; i < rows.size(); ++i)
      result(static_cast<Index>(i), static_cast<Index>(j)) = column[rows[i]];
  }
  return result;
}

/// E (Tᵀ)_child, with the columns of T from `first` on: those on the skeleton are columns
/// of E.
Matrix responseToWeights(const Matrix& response, const Interpolation& t, Index first) {
  const Index last = first + response.rows();
  Matrix result(response.rows(), t.rows());
  for (Index j = 0; j < t.rows(); ++j) {
    const Index place = t.skeleton[j];
    if (place >= first && place < last)
      std::copy_n(response.column(place - first), response.rows(), result.column(j));
  }
  const auto begin = std::lower_bound(t.rest.begin(), t.rest.end(), first);
  const auto end = std::lower_bound(t.rest.begin(), t.rest.end(), last);
  Matrix columns = Matrix::unset(response.rows(), end - begin);
  for (auto place = begin; place != end; ++place)
    std::copy_n(response.column(*place - first), response.rows(),
                columns.column(place - begin));
  addProduct(
      1, columns,
      transposed(columnsBetween(t.weights, begin - t.rest.begin(), end - t.rest.begin())),
      result);
  return result;
}

/// X <- F⁻¹ X.  With L = E₂ Sᵀ and U = E₁ S:  x₂ = (I - L U)⁻¹ (b₂ - L b₁),  x₁ = b₁ - U x₂.
/// \param subtractLower, subtractUpper (x, y): y -= L x, y -= U x
template <class Lower, class Upper>
void solveParent(const LuFactor& schur, Index split, const Lower& subtractLower,
                 const Upper& subtractUpper, MatrixView x) {
  const MatrixView first = x.rowsBetween(0, split);
  const MatrixView second = x.rowsBetween(split, x.rows());
  subtractLower(first, second);
  schur.solve(second);
  subtractUpper(second, first);
}

}  // namespace

Matrix Response::full(Index skeleton) const {
  Matrix result(skeleton, skeleton);
  for (std::size_t j = 0; j < places.size(); ++j)
    for (std::size_t i = 0; i < places.size(); ++i)
      result(places[i], places[j]) = matrix(static_cast<Index>(i), static_cast<Index>(j));
  return result;
}

Response Response::of(const Matrix& full) {
  std::vector<char> occurs(at(full.rows()));  // with followers E is not symmetric
  for (Index j = 0; j < full.columns(); ++j)
    for (Index i = 0; i < full.rows(); ++i)
      if (full(i, j) != 0)
        occurs[at(i)] = occurs[at(j)] = 1;
  Response result;
  for (Index i = 0; i < full.rows(); ++i)
    if (occurs[at(i)] != 0)
      result.places.push_back(i);
  result.matrix = between(full, result.places, result.places);
  return result;
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, LeafRestriction restriction,
                                     const Matrix& d, Response& response)
    : own_(std::move(restriction)), isSilent_(own_.kept.empty()), unknowns_(d.rows()) {
  if (isSilent_)
    return;
  Matrix own = between(d, own_.kept, own_.kept);
  for (const auto& [follower, leader, factor] : own_.followers)
    for (Index i = 0; i < own.rows(); ++i)
      own(i, leader) += factor * d(own_.kept[i], follower);
  for (const Entry& entry : own_.added)
    own(entry.row, entry.column) += entry.value;
  lu_ = LuFactor::ofScaledRows(std::move(own), compressedSystem);
  if (part.weights.rows() == 0)
    return;
  std::vector<Index> moving = own_.kept;
  for (const Entry& entry : own_.followers)
    moving.push_back(entry.row);
  part.weights.on(moving, response.places);
  Matrix answers = between(part.weights.transposed(), own_.kept, response.places);
  lu_.solve(answers);
  response.matrix = rowsOf(outgoing(part, answers), response.places);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Response& first,
                                     const Response& second)
    : unknowns_(static_cast<Index>(part.active.size())) {
  own_.kept = first.places;
  for (const Index place : second.places)
    own_.kept.push_back(part.block.rows() + place);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, Child first, Child second,
                                     Response& response)
    : EliminatedCluster(part, *first, *second) {
  first_ = std::move(first);
  second_ = std::move(second);
  const Matrix& e1 = first_->matrix;
  const Matrix& e2 = second_->matrix;
  if (e1.rows() < part.block.rows() || e2.rows() < part.block.columns())
    block_ = between(part.block, first_->places, second_->places);
  const Matrix upper = product(e1, block(part));
  const Matrix lower = product(e2, transposed(block(part)));
  Matrix rest(e2.rows(), e2.rows());
  addProduct(-1, lower, upper, rest);
  addIdentity(rest);
  lu_ = LuFactor::ofScaledRows(std::move(rest), compressedSystem);
  if (part.weights.rows() == 0)
    return;
  const Interpolation t = part.weights.on(own_.kept, response.places);
  Matrix answers =
      stacked(responseToWeights(e1, t, 0), responseToWeights(e2, t, e1.rows()));
  solveParent(
      lu_, e1.rows(),
      [&](ConstMatrixView x, MatrixView y) { addProduct(-1, lower, x, y); },
      [&](ConstMatrixView x, MatrixView y) { addProduct(-1, upper, x, y); }, answers);
  response.matrix = rowsOf(outgoing(part, answers), response.places);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Response& first,
                                     const Response& second, const Matrix& p)
    : EliminatedCluster(part, first, second) {
  const Index split = first.matrix.rows();
  const Matrix own = between(p, own_.kept, own_.kept);
  Matrix f = stacked(product(first.matrix, rowsBetween(own, 0, split)),
                     product(second.matrix, rowsBetween(own, split, own.rows())));
  addIdentity(f);
  lu_ = LuFactor::ofScaledRows(std::move(f), compressedSystem);
}

Matrix EliminatedCluster::outgoing(const ClusterPart& part, const Matrix& x) const {
  return part.weights.times(expanded(x));
}

void EliminatedCluster::solve(const ClusterPart& part, Matrix& x) const {
  if (first_ == nullptr) {
    lu_.solve(x);
    return;
  }
  const Matrix& s = block(part);
  solveParent(
      lu_, first_->matrix.rows(),
      [&](ConstMatrixView from, MatrixView to) {
        addProduct(-1, second_->matrix, transposedProduct(s, from), to);
      },
      [&](ConstMatrixView from, MatrixView to) {
        addProduct(-1, first_->matrix, product(s, from), to);
      },
      x);
}

// Of children with fields z₁ = w₁ + S y₂ and z₂ = w₂ + Sᵀ y₁, w = Tᵀ z: y₁ = b₁ - E₁ z₁ and
// y₂ = b₂ - E₂ z₂, so that (I - L U) y₂ = b₂ - E₂ (w₂ + Sᵀ (b₁ - E₁ w₁)).
void EliminatedCluster::solve(const ClusterPart& part, Matrix& field, Matrix& x) const {
  Matrix outside = reduced(field);
  if (first_ == nullptr) {
    for (Index j = 0; j < x.columns(); ++j)
      for (Index i = 0; i < x.rows(); ++i)
        x(i, j) -= outside(i, j);
    lu_.solve(x);
    return;
  }
  const Matrix& s = block(part);
  const Index split = first_->matrix.rows();
  const MatrixView first = MatrixView(outside).rowsBetween(0, split);
  const MatrixView second = MatrixView(outside).rowsBetween(split, outside.rows());
  const MatrixView y1 = MatrixView(x).rowsBetween(0, split);
  const MatrixView y2 = MatrixView(x).rowsBetween(split, x.rows());
  Matrix alone = y1.copy();
  addProduct(-1, first_->matrix, first, alone);
  Matrix seen = second.copy();
  addTransposedProduct(1, s, alone, seen);
  addProduct(-1, second_->matrix, seen, y2);
  lu_.solve(y2);
  addProduct(1, s, y2, first);
  addProduct(-1, first_->matrix, first, y1);
  addTransposedProduct(1, s, y1, second);
  field = Matrix(field.rows(), field.columns());
  putRows(outside, own_.kept, field);
}

Matrix EliminatedCluster::reduced(const Matrix& x) const { return rowsOf(x, own_.kept); }

Matrix EliminatedCluster::expanded(const Matrix& x) const {
  Matrix all(unknowns_, x.columns());
  putRows(x, own_.kept, all);
  for (const auto& [follower, leader, factor] : own_.followers)
    for (Index j = 0; j < x.columns(); ++j)
      all(follower, j) += factor * x(leader, j);
  return all;
}

}  // namespace epafi::bem
