#include "bem/algebra/Products.hpp"
#include "bem/compressed/CompressedFactor.hpp"

namespace epafi::bem {

Matrix CompressedFactor::inside(int c, const Matrix* outside) const {
  const ClusterPart& part = operators_->part(c);
  const auto n = static_cast<Index>(part.active.size());
  const bool isLeaf = operators_->tree()[c].isLeaf();
  Matrix p = isLeaf ? part.block.copy() : Matrix(n, n);
  if (outside != nullptr)
    part.weights.addTransposed(product(*outside, part.weights.full()), p);
  if (isLeaf)
    return p;
  const Index split = part.block.rows();
  for (Index j = split; j < n; ++j)
    for (Index i = 0; i < split; ++i) {
      p(i, j) += part.block(i, j - split);
      p(j, i) += part.block(i, j - split);
    }
  return p;
}

// What everything outside a cluster answers to what leaves it, z = O y.  Of children with
// y₂ = -E₂ z₂ and
//
//   z₁ = P₁₁ y₁ + P₁₂ y₂,   z₂ = P₂₁ y₁ + P₂₂ y₂,   P = [0 S; Sᵀ 0] + Tᵀ O T,
//
// the first's is   O₁ = P₁₁ - P₁₂ (I + E₂ P₂₂)⁻¹ E₂ P₂₁.
Matrix CompressedFactor::outsideOf(int child, const Matrix& p) const {
  const Cluster& parent = operators_->tree()[operators_->tree()[child].parent];
  const bool isFirst = parent.children[0] == child;
  const Index split = operators_->skeletonOf(parent.children[0]);
  const auto block = [&](bool first, bool second) {
    return rowsBetween(
        columnsBetween(p, second ? 0 : split, second ? split : p.columns()),
        first ? 0 : split, first ? split : p.rows());
  };
  const Matrix& other = response(parent.children[isFirst ? 1 : 0]);
  Matrix system = product(other, block(!isFirst, !isFirst));
  for (Index i = 0; i < system.rows(); ++i)
    system(i, i) += 1;
  Matrix answers = product(other, block(!isFirst, isFirst));
  LuFactor::ofScaledRows(std::move(system), compressedSystem).solve(answers);
  Matrix result = block(isFirst, isFirst);
  addProduct(-1, block(isFirst, !isFirst), answers, result);
  return result;
}

}  // namespace epafi::bem
