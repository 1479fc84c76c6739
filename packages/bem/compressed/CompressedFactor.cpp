#include "bem/compressed/CompressedFactor.hpp"

#include "bem/algebra/SerialBlas.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/ByColumns.hpp"
#include "bem/compressed/Products.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace epafi::bem {

namespace {

void scaleRows(const Vector& scales, Matrix& x) {
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      x(i, j) *= scales[at(i)];
}

}  // namespace

CompressedFactor::CompressedFactor(const CompressedOperators& operators,
                                   Restriction restriction,
                                   const std::vector<int>& changing)
    : operators_(&operators),
      restriction_(std::move(restriction)),
      changing_(operators.tree().paths(changing)),
      nodes_(static_cast<std::size_t>(operators.tree().size())),
      responses_(nodes_.size()) {
  restriction_.held.resize(at(operators.size()));
  eliminate(std::vector<char>(nodes_.size(), 1));
}

CompressedFactor::CompressedFactor(const CompressedOperators& operators,
                                   Restriction restriction)
    : CompressedFactor(operators, std::move(restriction),
                       operators.tree().cut(operators.tree().levels() - 1)) {}

int CompressedFactor::update(Restriction restriction) {
  restriction.held.resize(at(operators_->size()));
  std::vector<int> changed;
  for (Index i = 0; i < operators_->size(); ++i)
    if (restriction.held[at(i)] != restriction_.held[at(i)])
      changed.push_back(operators_->leafOf(i));
  const auto compare = [&](auto before, auto now, const auto& key) {
    const auto less = [&](const auto& a, const auto& b) { return key(a) < key(b); };
    std::sort(before.begin(), before.end(), less);
    std::sort(now.begin(), now.end(), less);
    std::remove_reference_t<decltype(now)> differing;
    std::set_symmetric_difference(before.begin(), before.end(), now.begin(), now.end(),
                                  std::back_inserter(differing), less);
    for (const auto& each : differing)
      changed.push_back(operators_->leafOf(std::get<0>(key(each))));
  };
  compare(restriction_.followers, restriction.followers,
          [](const Restriction::Follower& f) {
            return std::tuple(f.unknown, f.leader, f.factor);
          });
  compare(restriction_.entries, restriction.entries, [](const Restriction::Entry& e) {
    return std::tuple(e.row, e.column, e.value);
  });
  restriction_ = std::move(restriction);
  const std::vector<char> dirty = operators_->tree().paths(changed);
  for (std::size_t c = 0; c < dirty.size(); ++c)
    if (dirty[c] > changing_[c])
      throw std::logic_error("a leaf of the compressed system changes that may not");
  eliminate(dirty);
  return static_cast<int>(std::count(dirty.begin(), dirty.end(), 1));
}

std::vector<CompressedFactor::Node> CompressedFactor::restricted(
    const std::vector<char>& dirty) const {
  const ClusterTree& tree = operators_->tree();
  std::vector<Node> nodes(nodes_.size());
  // of each leaf, where unknowns stand
  std::vector<Index> places(at(operators_->size()));
  for (int c = 0; c < tree.size(); ++c)
    if (tree[c].isLeaf() && dirty[static_cast<std::size_t>(c)] != 0) {
      const std::vector<Index>& active = operators_->part(c).active;
      Node& node = nodes[static_cast<std::size_t>(c)];
      for (std::size_t i = 0; i < active.size(); ++i)
        if (restriction_.held[at(active[i])] == 0) {
          places[at(active[i])] = static_cast<Index>(node.kept.size());
          node.kept.push_back(static_cast<Index>(i));
        } else {
          places[at(active[i])] = static_cast<Index>(i);
        }
    }
  for (const Restriction::Follower& follower : restriction_.followers) {
    const auto c = static_cast<std::size_t>(operators_->leafOf(follower.unknown));
    assert(operators_->leafOf(follower.leader) == static_cast<int>(c));
    if (dirty[c] != 0 && restriction_.held[at(follower.leader)] == 0)
      nodes[c].followers.push_back(
          {places[at(follower.unknown)], places[at(follower.leader)], follower.factor});
  }
  const auto add = [&](const Restriction::Entry& entry) {
    const auto c = static_cast<std::size_t>(operators_->leafOf(entry.row));
    assert(operators_->leafOf(entry.column) == static_cast<int>(c));
    if (dirty[c] != 0 && restriction_.held[at(entry.row)] == 0 &&
        restriction_.held[at(entry.column)] == 0)
      nodes[c].added.push_back(
          {places[at(entry.row)], places[at(entry.column)], entry.value});
  };
  std::for_each(restriction_.entries.begin(), restriction_.entries.end(), add);
  for (const Index i : operators_->floating())
    add({i, i, 1});
  return nodes;
}

void CompressedFactor::eliminate(const std::vector<char>& dirty) {
  const SerialBlas serial;
  const ClusterTree& tree = operators_->tree();
  std::vector<Node> nodes = restricted(dirty);
  for (int l = tree.levels() - 1; l >= 0; --l) {
    std::vector<int> level;
    std::copy_if(tree.level(l).begin(), tree.level(l).end(), std::back_inserter(level),
                 [&](int c) { return dirty[static_cast<std::size_t>(c)] != 0; });
    std::string failure;
    // a single cluster has the threads for itself, see byColumns
#pragma omp parallel for schedule(dynamic, 1) if (level.size() > 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const auto c = static_cast<std::size_t>(level[k]);
      try {
        const bool isLeaf = tree[level[k]].isLeaf();
        responses_[c] =
            std::make_shared<const Matrix>(isLeaf ? eliminateLeaf(level[k], nodes[c])
                                                  : eliminateParent(level[k], nodes[c]));
        if (!isLeaf && changing_[c] == 0)
          for (const int child : tree[level[k]].children)
            responses_[static_cast<std::size_t>(child)] = nullptr;
        nodes_[c] = std::make_shared<const Node>(std::move(nodes[c]));
      } catch (const NumericalError& error) {
#pragma omp critical(epafi_compressed_factor)
        failure = error.what();
      }
    }
    if (!failure.empty())
      throw NumericalError(failure);
  }
  takeSpringsBack();
  addRotations();
}

void CompressedFactor::addRotations() {
  const CompressedOperators::Rotations& rotations = operators_->rotations();
  rotated_ = nullptr;
  if (rotations.columns.empty())
    return;
  Rotated rotated;
  Matrix right = rotations.columns.copy();
  for (Index j = 0; j < right.columns(); ++j)
    for (Index i = 0; i < right.rows(); ++i)
      if (restriction_.held[at(i)] != 0)
        right(i, j) = 0;
  rotated.answers = solveStraight(right, std::vector<char>(nodes_.size(), 1));
  Matrix rest = rotations.inverse.copy();
  addTransposedProduct(1, rotations.columns, rotated.answers, rest);
  rotated.rest.factor(std::move(rest));
  rotated_ = std::make_shared<const Rotated>(std::move(rotated));
}

void CompressedFactor::takeSpringsBack() {
  sprung_.clear();
  for (const Index i : operators_->floating())
    if (restriction_.held[at(i)] == 0)
      sprung_.push_back(i);
  const auto count = static_cast<Index>(sprung_.size());
  Matrix units(operators_->size(), count);
  for (Index k = 0; k < count; ++k)
    units(sprung_[at(k)], k) = 1;
  Matrix rest = count > 0 ? rowsOf(solveSprung(units, paths({})), sprung_) : Matrix();
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i < count; ++i)
      rest(i, j) = (i == j ? 1 : 0) - rest(i, j);
  Node springs;
  springs.factor(std::move(rest));
  springs_ = std::make_shared<const Node>(std::move(springs));
}

std::vector<char> CompressedFactor::paths(std::vector<int> leaves) const {
  for (const Index i : operators_->floating())
    leaves.push_back(operators_->leafOf(i));
  return operators_->tree().paths(leaves);
}

Matrix CompressedFactor::eliminateLeaf(int c, Node& node) const {
  const CompressedOperators::Part& part = operators_->part(c);
  const auto n = static_cast<Index>(node.kept.size());
  const Index k = part.weights.rows();
  if (n == 0) {
    node.isSilent = true;
    return Matrix(k, k);
  }
  Matrix d(n, n);
  Matrix in(n, k);
  node.ownOut = n < part.weights.columns() || !node.followers.empty();
  node.out = Matrix(k, node.ownOut ? n : 0);
  for (Index j = 0; j < n; ++j) {
    const Index column = node.kept[at(j)];
    for (Index i = 0; i < n; ++i)
      d(i, j) = part.block(node.kept[at(i)], column);
    if (node.ownOut)
      std::copy_n(part.weights.column(column), k, node.out.column(j));
    for (Index i = 0; i < k; ++i)
      in(j, i) = part.weights(i, column);
  }
  for (const Node::Follower& follower : node.followers) {
    for (Index i = 0; i < n; ++i)
      d(i, follower.leader) +=
          follower.factor * part.block(node.kept[at(i)], follower.follower);
    for (Index i = 0; i < k; ++i)
      node.out(i, follower.leader) +=
          follower.factor * part.weights(i, follower.follower);
  }
  for (const Restriction::Entry& entry : node.added)
    d(entry.row, entry.column) += entry.value;
  node.factor(std::move(d));
  node.solve(in);
  node.in = std::move(in);
  return product(node.outOf(part), node.in);
}

Matrix CompressedFactor::eliminateParent(int c, Node& node) const {
  const ClusterTree& tree = operators_->tree();
  const CompressedOperators::Part& part = operators_->part(c);
  const auto responseOf = [&](int child) -> const Matrix& {
    return *responses_[static_cast<std::size_t>(tree[c].children[child])];
  };
  const auto isSilent = [&](int child) {
    return nodes_[static_cast<std::size_t>(tree[c].children[child])]->isSilent;
  };
  if (isSilent(0) && isSilent(1)) {
    node.isSilent = true;
    return Matrix(part.weights.rows(), part.weights.rows());
  }
  const Matrix& first = responseOf(0);
  const Matrix& second = responseOf(1);
  const Index k = first.rows();
  const Index size = k + second.rows();
  Matrix f(size, size);
  const Matrix right = product(first, part.block);
  const Matrix left = product(second, transposed(part.block));
  for (Index j = 0; j < size; ++j) {
    if (j < k)
      std::copy_n(left.column(j), size - k, f.column(j) + k);
    else
      std::copy_n(right.column(j - k), k, f.column(j));
    f(j, j) += 1;
  }
  node.factor(std::move(f));
  if (c == 0)
    return {};
  const Matrix weights = transposed(part.weights);
  node.in = stacked(product(first, rowsBetween(weights, 0, k)),
                    product(second, rowsBetween(weights, k, size)));
  node.solve(node.in);
  return product(part.weights, node.in);
}

void CompressedFactor::Node::factor(Matrix matrix) {
  lu = std::move(matrix);
  const int n = static_cast<int>(lu.rows());
  pivots.resize(at(n));
  scales.assign(at(n), 0.0);
  if (n == 0)
    return;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      scales[at(i)] = std::max(scales[at(i)], std::abs(lu(i, j)));
  for (double& scale : scales)
    scale = scale > 0 ? 1 / scale : 1;
  scaleRows(scales, lu);
  const int lda = static_cast<int>(lu.stride());
  int info = 0;
  dgetrf_(&n, &n, lu.data(), &lda, pivots.data(), &info);
  if (info != 0)
    throw NumericalError("the compressed system is singular");
}

void CompressedFactor::Node::solve(Matrix& x) const {
  const int n = static_cast<int>(lu.rows());
  if (n == 0)
    return;
  scaleRows(scales, x);
  const int lda = static_cast<int>(lu.stride());
  const int ldb = static_cast<int>(x.stride());
  byColumns(x.columns(), [&](Index first, Index count) {
    const int columns = static_cast<int>(count);
    int info = 0;
    dgetrs_("N", &n, &columns, lu.data(), &lda, pivots.data(), x.column(first), &ldb,
            &info);
  });
}

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
  const auto node = [&](int c) -> const Node& {
    return *nodes_[static_cast<std::size_t>(c)];
  };
  const auto isOff = [&](int c) {
    return paths[static_cast<std::size_t>(c)] == 0 || node(c).isSilent;
  };
  const auto of = [](std::vector<Matrix>& all, int c) -> Matrix& {
    return all[static_cast<std::size_t>(c)];
  };
  for (int l = tree.levels() - 1; l >= 0; --l) {
    const std::vector<int>& level = tree.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      const CompressedOperators::Part& part = operators_->part(c);
      if (isOff(c)) {
        of(out, c) = Matrix(part.weights.rows(), columns);
        continue;
      }
      if (tree[c].isLeaf()) {
        std::vector<Index> rows;
        for (const Index i : node(c).kept)
          rows.push_back(part.active[at(i)]);
        of(inner, c) = rowsOf(b, rows);
      } else {
        of(inner, c) =
            stacked(of(out, tree[c].children[0]), of(out, tree[c].children[1]));
      }
      node(c).solve(of(inner, c));
      if (l > 0)
        of(out, c) = product(node(c).outOf(part), of(inner, c));
    }
  }
  for (int l = 0; l < tree.levels(); ++l) {
    const std::vector<int>& level = tree.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      if (isOff(c))
        continue;
      const CompressedOperators::Part& part = operators_->part(c);
      Matrix& own = of(inner, c);
      if (l > 0)
        addProduct(-1, node(c).in, of(in, c), own);
      if (tree[c].isLeaf()) {
        for (Index j = 0; j < columns; ++j) {
          for (std::size_t i = 0; i < node(c).kept.size(); ++i)
            x(part.active[at(node(c).kept[i])], j) = own(static_cast<Index>(i), j);
          for (const Node::Follower& follower : node(c).followers)
            x(part.active[at(follower.follower)], j) +=
                follower.factor * own(follower.leader, j);
        }
        continue;
      }
      const Index split = of(out, tree[c].children[0]).rows();
      const Matrix first = rowsBetween(own, 0, split);
      const Matrix second = rowsBetween(own, split, own.rows());
      Matrix outside(own.rows(), columns);
      if (l > 0)
        addTransposedProduct(1, part.weights, of(in, c), outside);
      of(in, tree[c].children[0]) = rowsBetween(outside, 0, split);
      of(in, tree[c].children[1]) = rowsBetween(outside, split, own.rows());
      addProduct(1, part.block, second, of(in, tree[c].children[0]));
      addTransposedProduct(1, part.block, first, of(in, tree[c].children[1]));
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

std::size_t CompressedFactor::bytes() const {
  std::size_t entries = 0;
  const auto count = [&](const Matrix& matrix) {
    entries += static_cast<std::size_t>(matrix.rows() * matrix.columns());
  };
  for (const std::shared_ptr<const Node>& node : nodes_)
    for (const Matrix* matrix : {&node->lu, &node->in, &node->out})
      count(*matrix);
  for (const std::shared_ptr<const Matrix>& response : responses_)
    if (response != nullptr)
      count(*response);
  return entries * sizeof(double);
}

}  // namespace epafi::bem
