#include "bem/algebra/Products.hpp"
#include "bem/base/BlasThreads.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/compressed/TreeSweeps.hpp"

#include <stdexcept>

namespace epafi::bem {

Matrix CompressedFactor::solveSprung(const Matrix& b,
                                     const std::vector<char>& paths) const {
  const ClusterTree& tree = operators_->tree();
  const Subtrees& subtrees = operators_->subtrees();
  const Index columns = b.columns();
  Matrix x(b.rows(), columns);
  std::vector<Matrix> inner(nodes_.size());
  std::vector<Matrix> out(nodes_.size());
  std::vector<Matrix> in(nodes_.size());
  // what nobody has here is on no path that is followed
  std::vector<char> on = paths;
  for (int c = 0; c < tree.size(); ++c)
    if (nodes_[c] == nullptr || node(c).isSilent())
      on[c] = 0;
  const auto outOf = [&](int c) {
    return on[c] != 0 ? std::move(out[c]) : Matrix(operators_->skeletonOf(c), columns);
  };
  const auto up = [&](int c) {
    const ClusterPart& part = operators_->part(c);
    inner[c] = node(c).reduced(tree[c].isLeaf() ? rowsOf(b, part.active)
                                                : stacked(outOf(tree[c].children[0]),
                                                          outOf(tree[c].children[1])));
    if (c == top_)
      return;
    Matrix own = inner[c].copy();
    node(c).solve(part, own);
    out[c] = node(c).outgoing(part, own);
  };
  const auto down = [&](int c) {
    const ClusterPart& part = operators_->part(c);
    Matrix field(static_cast<Index>(part.active.size()), columns);
    if (c != top_)
      part.weights.addTransposed(in[c], field);
    node(c).solve(part, field, inner[c]);
    if (tree[c].isLeaf()) {
      putRows(node(c).expanded(inner[c]), part.active, x);
      return;
    }
    if (c == top_ && top_ != 0)
      field = product(*whole_, node(c).expanded(inner[c]));
    const Index split = part.block.rows();
    in[tree[c].children[0]] = rowsBetween(field, 0, split).copy();
    in[tree[c].children[1]] = rowsBetween(field, split, field.rows()).copy();
  };
  const double check = subtrees.isAlone() ? 0 : checkOf(b);
  const auto work = [&](int c) { return operators_->part(c).sweepWork(columns); };
  upwards(tree, subtrees, on, work, up, [&] {
    if (subtrees.isEverybodys(top_))
      subtrees.exchangeRoots(
          on, check, [&](int c) { return operators_->skeletonOf(c); }, columns, out);
  });
  downwards(tree, subtrees, on, work, down);
  operators_->exchangeRows(paths, check, x);
  return x;
}

Matrix CompressedFactor::solveOnce(const Matrix& b,
                                   const std::vector<char>& paths) const {
  if (border_ == nullptr)
    return solveSprung(b, paths);
  // a rotation is everywhere
  const bool turns = operators_->rotations().u.columns() > 0;
  Matrix x = solveSprung(b, turns ? std::vector<char>(nodes_.size(), 1) : paths);
  border_->correct(x);
  return x;
}

// What rounds in the forces of a product bends slender bodies, by 1e-4 of the displacement of a
// beam of 1 : 30; what the elimination leaves of forces does not.
Matrix CompressedFactor::leftOfDensities(const Matrix& b, const Matrix& x) const {
  const Matrix image = operators_->times(x);
  Matrix left(b.rows(), b.columns());
  for (std::size_t body = 0; body < operators_->bodies(); ++body) {
    const CompressedOperators::Range& range = operators_->range(body);
    for (Index j = 0; j < b.columns(); ++j)
      for (Index i = range.densities; i < range.last; ++i)
        if (restriction_.held[i] == 0)
          left(i, j) = b(i, j) - image(i, j);
  }
  return left;
}

Matrix CompressedFactor::solveAlong(const std::vector<char>& paths,
                                    const Matrix& b) const {
  const BlasThreads serial(1);
  return solveOnce(b, paths);
}

Matrix CompressedFactor::solve(const Matrix& b, int refinements) const {
  if (top_ != 0)
    throw std::logic_error("a part of the compressed system does not know all unknowns");
  const BlasThreads serial(1);
  const std::vector<char> all(nodes_.size(), 1);
  Matrix x = solveOnce(b, all);
  for (int step = 0; step < refinements; ++step)
    addTo(x, solveOnce(leftOfDensities(b, x), all));
  return x;
}

}  // namespace epafi::bem
