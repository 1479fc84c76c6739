#include "bem/algebra/SerialBlas.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/compressed/Products.hpp"

#include <cassert>

namespace epafi::bem {

// With M = Z + P Pᵀ, springs on sprung_:
//   Z⁻¹ b = M⁻¹ (b + P s),   (I - Pᵀ M⁻¹ P) s = Pᵀ M⁻¹ b
Matrix CompressedFactor::solveStraight(const Matrix& b,
                                       const std::vector<char>& paths) const {
  Matrix x = solveSprung(b, paths);
  if (sprung_.empty())
    return x;
  Matrix forces = rowsOf(x, sprung_);
  springs_->solve(forces);
  Matrix right = b.copy();
  for (Index j = 0; j < b.columns(); ++j)
    for (std::size_t k = 0; k < sprung_.size(); ++k)
      right(sprung_[k], j) += forces(static_cast<Index>(k), j);
  return solveSprung(right, paths);
}

Matrix CompressedFactor::solveSprung(const Matrix& b,
                                     const std::vector<char>& paths) const {
  const ClusterTree& tree = operators_->tree();
  const Index columns = b.columns();
  Matrix x(b.rows(), columns);
  std::vector<Matrix> inner(nodes_.size());
  std::vector<Matrix> out(nodes_.size());
  std::vector<Matrix> in(nodes_.size());
  const auto isOn = [&](int c) {
    return paths[static_cast<std::size_t>(c)] != 0 && !node(c).isSilent();
  };
  const auto of = [](std::vector<Matrix>& all, int c) -> Matrix& {
    return all[static_cast<std::size_t>(c)];
  };
  const auto outOf = [&](int c) {
    Matrix result = isOn(c) ? std::move(of(out, c))
                            : Matrix(operators_->part(c).weights.rows(), columns);
    return result;
  };
  for (int l = tree.levels() - 1; l >= tree[top_].level; --l) {
    const std::vector<int>& level = tree.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      if (!isOn(c))
        continue;
      const ClusterPart& part = operators_->part(c);
      of(inner, c) = tree[c].isLeaf() ? node(c).reduced(rowsOf(b, part.active))
                                      : stacked(outOf(tree[c].children[0]),
                                                outOf(tree[c].children[1]));
      node(c).solve(of(inner, c));
      if (c != top_)
        of(out, c) = node(c).outgoing(part, of(inner, c));
    }
  }
  for (int l = tree[top_].level; l < tree.levels(); ++l) {
    const std::vector<int>& level = tree.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      if (!isOn(c))
        continue;
      const ClusterPart& part = operators_->part(c);
      Matrix& own = of(inner, c);
      if (c != top_)
        node(c).subtractOutside(of(in, c), own);
      if (tree[c].isLeaf()) {
        putRows(node(c).expanded(own), part.active, x);
        continue;
      }
      const Index split = part.block.rows();
      Matrix outside(own.rows(), columns);
      if (c == top_ && whole_ != nullptr)
        addProduct(1, *whole_, own, outside);
      else if (c != top_)
        part.weights.addTransposed(of(in, c), outside);
      Matrix& first = of(in, tree[c].children[0]);
      Matrix& second = of(in, tree[c].children[1]);
      first = rowsBetween(outside, 0, split);
      second = rowsBetween(outside, split, own.rows());
      if (c == top_ && whole_ != nullptr)
        continue;
      addProduct(1, part.block, rowsBetween(own, split, own.rows()), first);
      addTransposedProduct(1, part.block, rowsBetween(own, 0, split), second);
    }
  }
  return x;
}

// (Z + U S Uᵀ)⁻¹ b = y - Y (S⁻¹ + Uᵀ Y)⁻¹ Uᵀ y,  y = Z⁻¹ b
Matrix CompressedFactor::solveOnce(const Matrix& b,
                                   const std::vector<char>& paths) const {
  if (rotated_ == nullptr)
    return solveStraight(b, paths);
  // a rotation is everywhere
  Matrix x = solveStraight(b, std::vector<char>(nodes_.size(), 1));
  const Matrix& columns = operators_->rotations().columns;
  Matrix sizes(columns.columns(), x.columns());
  addTransposedProduct(1, columns, x, sizes);
  rotated_->rest.solve(sizes);
  addProduct(-1, rotated_->answers, sizes, x);
  return x;
}

Matrix CompressedFactor::residual(const Matrix& b, const Matrix& x) const {
  Matrix rest = operators_->times(x);
  for (const Restriction::Entry& entry : restriction_.entries)
    for (Index j = 0; j < x.columns(); ++j)
      rest(entry.row, j) += entry.value * x(entry.column, j);
  for (Index j = 0; j < b.columns(); ++j)
    for (Index i = 0; i < b.rows(); ++i)
      rest(i, j) = restriction_.held[at(i)] != 0 ? 0 : b(i, j) - rest(i, j);
  return rest;
}

Matrix CompressedFactor::solveAlong(const std::vector<char>& paths,
                                    const Matrix& b) const {
  const SerialBlas serial;
  return solveOnce(b, paths);
}

Matrix CompressedFactor::solve(const Matrix& b, int refinements) const {
  assert(whole_ == nullptr);
  const SerialBlas serial;
  const std::vector<char> all(nodes_.size(), 1);
  Matrix x = solveOnce(b, all);
  for (int step = 0; step < refinements; ++step) {
    const Matrix correction = solveOnce(residual(b, x), all);
    for (Index j = 0; j < x.columns(); ++j)
      for (Index i = 0; i < x.rows(); ++i)
        x(i, j) += correction(i, j);
  }
  return x;
}

}  // namespace epafi::bem
