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
                                     const Matrix& d)
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
  part.weights.on(moving, rows_);
  in_ = between(part.weights.transposed(), own_.kept, rows_);
  lu_.solve(in_);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Response& first,
                                     const Response& second, Index split)
    : unknowns_(static_cast<Index>(part.active.size())) {
  own_.kept = first.places;
  for (const Index place : second.places)
    own_.kept.push_back(split + place);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Response& first,
                                     const Response& second)
    : EliminatedCluster(part, first, second, part.block.rows()) {
  const Matrix s = between(part.block, first.places, second.places);
  upper_ = product(first.matrix, s);
  lower_ = product(second.matrix, transposed(s));
  Matrix rest(second.matrix.rows(), second.matrix.rows());
  addProduct(-1, lower_, upper_, rest);
  addIdentity(rest);
  lu_ = LuFactor::ofScaledRows(std::move(rest), compressedSystem);
  if (part.weights.rows() == 0)
    return;
  const Interpolation t = part.weights.on(own_.kept, rows_);
  in_ = stacked(responseToWeights(first.matrix, t, 0),
                responseToWeights(second.matrix, t, first.matrix.rows()));
  solve(in_);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Response& first,
                                     const Response& second, const Matrix& p)
    : EliminatedCluster(part, first, second, part.block.rows()) {
  const Index split = first.matrix.rows();
  const Matrix own = between(p, own_.kept, own_.kept);
  Matrix f = stacked(product(first.matrix, rowsBetween(own, 0, split)),
                     product(second.matrix, rowsBetween(own, split, own.rows())));
  addIdentity(f);
  lu_ = LuFactor::ofScaledRows(std::move(f), compressedSystem);
}

Response EliminatedCluster::response(const ClusterPart& part) const {
  if (isSilent_)
    return {};
  assert(part.weights.skeleton.size() + part.weights.rest.size() > 0);
  return {rows_, rowsOf(outgoing(part, in_), rows_)};
}

Matrix EliminatedCluster::outgoing(const ClusterPart& part, const Matrix& x) const {
  return part.weights.times(expanded(x));
}

// With L = E₂ Sᵀ and U = E₁ S:  x₂ = (I - L U)⁻¹ (b₂ - L b₁),  x₁ = b₁ - U x₂
void EliminatedCluster::solve(Matrix& x) const {
  if (upper_.rows() == 0) {
    lu_.solve(x);
    return;
  }
  Matrix first = rowsBetween(x, 0, upper_.rows());
  Matrix second = rowsBetween(x, upper_.rows(), x.rows());
  addProduct(-1, lower_, first, second);
  lu_.solve(second);
  addProduct(-1, upper_, second, first);
  x = stacked(first, second);
}

void EliminatedCluster::subtractOutside(const Matrix& z, Matrix& x) const {
  addProduct(-1, in_, rowsOf(z, rows_), x);
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
