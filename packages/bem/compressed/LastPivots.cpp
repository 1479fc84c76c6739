#include "bem/algebra/SerialBlas.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/compressed/Products.hpp"

namespace epafi::bem {

namespace {

Matrix minus(Matrix a) {
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      a(i, j) = -a(i, j);
  return a;
}

Matrix sum(Matrix a, const Matrix& b) {
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      a(i, j) += b(i, j);
  return a;
}

}  // namespace

// From the root down, what everything outside a cluster answers to what leaves it,
// z = O y.  Of children with y₂ = -E₂ z₂ and
//
//   z₁ = S y₂ + T₁ᵀ O (T₁ y₁ + T₂ y₂),   z₂ = Sᵀ y₁ + T₂ᵀ O (T₁ y₁ + T₂ y₂)
//
// the first's is   O₁ = P₁₁ - P₁₂ (I + E₂ P₂₂)⁻¹ E₂ P₁₂ᵀ,   P = [0 S; Sᵀ 0] + Tᵀ O T,
// and a leaf's unknowns feel   D + Tᵀ O T.
Vector CompressedFactor::lastPivots() const {
  const SerialBlas serial;
  const ClusterTree& tree = operators_->tree();
  std::vector<Matrix> outside(nodes_.size());
  Vector pivots(at(operators_->size()));
  const auto whole = [&](int c, Matrix inner) {
    const CompressedOperators::Part& part = operators_->part(c);
    if (c > 0)
      addTransposedProduct(1, part.weights,
                           product(outside[static_cast<std::size_t>(c)], part.weights),
                           inner);
    return inner;
  };
  for (int c = 0; c < tree.size(); ++c) {
    if (changing_[static_cast<std::size_t>(c)] == 0)
      continue;
    const CompressedOperators::Part& part = operators_->part(c);
    if (tree[c].isLeaf()) {
      addLastPivots(c, whole(c, part.block.copy()), pivots);
      continue;
    }
    const Index n = static_cast<Index>(part.active.size());
    const Index split = part.block.rows();
    Matrix p(n, n);
    for (Index j = split; j < n; ++j)
      for (Index i = 0; i < split; ++i)
        p(i, j) = p(j, i) = part.block(i, j - split);
    p = whole(c, std::move(p));
    const auto block = [&](int row, int column) {
      return rowsBetween(
          columnsBetween(p, column == 0 ? 0 : split, column == 0 ? split : n),
          row == 0 ? 0 : split, row == 0 ? split : n);
    };
    for (const int own : {0, 1}) {
      const auto other = static_cast<std::size_t>(tree[c].children[1 - own]);
      const Matrix& response = *responses_[other];
      Matrix system = product(response, block(1 - own, 1 - own));
      for (Index i = 0; i < system.rows(); ++i)
        system(i, i) += 1;
      Node node;
      node.factor(std::move(system));
      Matrix answers = product(response, block(1 - own, own));
      node.solve(answers);
      outside[static_cast<std::size_t>(tree[c].children[own])] =
          sum(minus(product(block(own, 1 - own), answers)), block(own, own));
    }
  }
  return pivots;
}

// Of a leaf with the matrix D:  D_ii - D_iK D_KK⁻¹ D_Ki,  K what is not held.
void CompressedFactor::addLastPivots(int c, const Matrix& leaf, Vector& pivots) const {
  const Node& node = *nodes_[static_cast<std::size_t>(c)];
  const std::vector<Index>& active = operators_->part(c).active;
  std::vector<Index> held;
  for (std::size_t i = 0; i < active.size(); ++i)
    if (restriction_.held[at(active[i])] != 0)
      held.push_back(static_cast<Index>(i));
  const Matrix rows = rowsOf(leaf, node.kept);
  Matrix kept = transposed(rowsOf(transposed(rows), node.kept));
  for (const Restriction::Entry& entry : node.added)
    kept(entry.row, entry.column) += entry.value;
  const Matrix columns = transposed(rowsOf(transposed(rows), held));
  Matrix answers = columns.copy();
  Node inner;
  inner.factor(std::move(kept));
  inner.solve(answers);
  for (std::size_t k = 0; k < held.size(); ++k) {
    double pivot = leaf(held[k], held[k]);
    for (Index i = 0; i < answers.rows(); ++i)
      pivot -= columns(i, static_cast<Index>(k)) * answers(i, static_cast<Index>(k));
    pivots[at(active[at(held[k])])] = pivot;
  }
}

}  // namespace epafi::bem
