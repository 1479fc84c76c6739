#include "bem/compressed/EliminatedCluster.hpp"

#include "bem/algebra/Products.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

void addIdentity(Matrix& a) {
  for (Index i = 0; i < a.rows(); ++i)
    a(i, i) += 1;
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
  Matrix columns(response.rows(), end - begin);
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

EliminatedCluster::EliminatedCluster(const ClusterPart& part, LeafRestriction restriction,
                                     const Matrix& d)
    : leaf_(std::move(restriction)),
      isLeaf_(true),
      isSilent_(leaf_.kept.empty()),
      unknowns_(d.rows()) {
  if (isSilent_)
    return;
  const auto n = static_cast<Index>(leaf_.kept.size());
  Matrix own(n, n);
  for (Index j = 0; j < n; ++j) {
    const double* column = d.column(leaf_.kept[j]);
    for (Index i = 0; i < n; ++i)
      own(i, j) = column[leaf_.kept[i]];
  }
  for (const auto& [follower, leader, factor] : leaf_.followers)
    for (Index i = 0; i < n; ++i)
      own(i, leader) += factor * d(leaf_.kept[i], follower);
  for (const Entry& entry : leaf_.added)
    own(entry.row, entry.column) += entry.value;
  lu_ = LuFactor::ofScaledRows(std::move(own), compressedSystem);
  if (part.weights.rows() == 0)
    return;
  in_ = reduced(part.weights.transposed());
  lu_.solve(in_);
}

EliminatedCluster::EliminatedCluster(const ClusterPart& part, const Matrix& first,
                                     const Matrix& second)
    : upper_(product(first, part.block)),
      lower_(product(second, transposed(part.block))) {
  Matrix rest(second.rows(), second.rows());
  addProduct(-1, lower_, upper_, rest);
  addIdentity(rest);
  lu_ = LuFactor::ofScaledRows(std::move(rest), compressedSystem);
  in_ = stacked(responseToWeights(first, part.weights, 0),
                responseToWeights(second, part.weights, first.rows()));
  solve(in_);
}

EliminatedCluster::EliminatedCluster(const Matrix& first, const Matrix& second,
                                     const Matrix& p) {
  const Index split = first.rows();
  Matrix f = stacked(product(first, rowsBetween(p, 0, split)),
                     product(second, rowsBetween(p, split, p.rows())));
  addIdentity(f);
  lu_ = LuFactor::ofScaledRows(std::move(f), compressedSystem);
}

Matrix EliminatedCluster::response(const ClusterPart& part) const {
  if (isSilent_)
    return Matrix(part.weights.rows(), part.weights.rows());
  return outgoing(part, in_);
}

Matrix EliminatedCluster::outgoing(const ClusterPart& part, const Matrix& x) const {
  if (isLeaf_)
    return part.weights.times(expanded(x));
  return part.weights.times(x);
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
  addProduct(-1, in_, z, x);
}

Matrix EliminatedCluster::reduced(const Matrix& x) const { return rowsOf(x, leaf_.kept); }

Matrix EliminatedCluster::expanded(const Matrix& x) const {
  Matrix all(unknowns_, x.columns());
  putRows(x, leaf_.kept, all);
  for (const auto& [follower, leader, factor] : leaf_.followers)
    for (Index j = 0; j < x.columns(); ++j)
      all(follower, j) += factor * x(leader, j);
  return all;
}

}  // namespace epafi::bem
