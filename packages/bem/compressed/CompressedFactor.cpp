#include "bem/compressed/CompressedFactor.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/base/BlasThreads.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/TreeSweeps.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <tuple>

namespace epafi::bem {

CompressedFactor::CompressedFactor(const CompressedOperators& operators,
                                   Restriction restriction)
    : operators_(&operators),
      restriction_(std::move(restriction)),
      unfinished_(operators.tree().size()),
      nodes_(operators.tree().size()),
      responses_(nodes_.size()) {
  restriction_.held.resize(operators.size());
  eliminate(std::vector<char>(nodes_.size(), 1));
}

int CompressedFactor::update(Restriction restriction) {
  restriction.held.resize(operators_->size());
  std::vector<int> changed;
  for (Index i = 0; i < operators_->size(); ++i)
    if (restriction.held[i] != restriction_.held[i])
      changed.push_back(operators_->leafOf(i));
  const auto compare = [&](std::vector<Entry> before, std::vector<Entry> now) {
    const auto less = [](const Entry& a, const Entry& b) {
      return std::tie(a.row, a.column, a.value) < std::tie(b.row, b.column, b.value);
    };
    std::sort(before.begin(), before.end(), less);
    std::sort(now.begin(), now.end(), less);
    std::vector<Entry> differing;
    std::set_symmetric_difference(before.begin(), before.end(), now.begin(), now.end(),
                                  std::back_inserter(differing), less);
    for (const Entry& each : differing)
      changed.push_back(operators_->leafOf(each.row));
  };
  compare(restriction_.followers, restriction.followers);
  compare(restriction_.entries, restriction.entries);
  for (const int leaf : changed)
    if (!operators_->tree().contains(top_, leaf))
      throw std::logic_error("a leaf outside a part of the compressed system changes");
  std::vector<char> dirty = withoutAbove(operators_->tree().paths(changed));
  for (std::size_t c = 0; c < dirty.size(); ++c)
    dirty[c] = std::max(dirty[c], unfinished_[c]);
  restriction_ = std::move(restriction);
  unfinished_ = dirty;
  eliminate(dirty);
  unfinished_.assign(dirty.size(), 0);
  return static_cast<int>(std::count(dirty.begin(), dirty.end(), 1));
}

CompressedFactor CompressedFactor::restrictedTo(const std::vector<int>& leaves) const {
  const ClusterTree& tree = operators_->tree();
  CompressedFactor result = *this;
  // springs and rotations act elsewhere
  if (leaves.empty() || border_ != nullptr)
    return result;
  const auto containsAll = [&](int c) {
    return std::all_of(leaves.begin(), leaves.end(),
                       [&](int leaf) { return tree.contains(c, leaf); });
  };
  Matrix whole = inside(0, nullptr);
  std::string failure;
  try {
    while (!tree[result.top_].isLeaf()) {
      const auto& children = tree[result.top_].children;
      const auto child =
          std::find_if(std::begin(children), std::end(children), containsAll);
      if (child == std::end(children))
        break;
      if (operators_->subtrees().isMine(*child)) {
        const Matrix outside = outsideOf(*child, whole);
        whole = inside(*child, &outside);
      }
      result.top_ = *child;
    }
  } catch (const NumericalError& error) {
    failure = error.what();
  }
  operators_->subtrees().agree(failure);
  if (result.top_ == 0)
    return result;
  result.whole_ = std::make_shared<const Matrix>(std::move(whole));
  std::vector<char> dirty(nodes_.size());
  dirty[result.top_] = 1;
  result.eliminate(dirty);
  return result;
}

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
  const int sibling = parent.children[isFirst ? 1 : 0];
  const Matrix other = response(sibling).full(operators_->skeletonOf(sibling));
  Matrix system = product(other, block(!isFirst, !isFirst));
  for (Index i = 0; i < system.rows(); ++i)
    system(i, i) += 1;
  Matrix answers = product(other, block(!isFirst, isFirst));
  LuFactor::ofScaledRows(std::move(system), compressedSystem).solve(answers);
  Matrix result = block(isFirst, isFirst).copy();
  addProduct(-1, block(isFirst, !isFirst), answers, result);
  return result;
}

std::vector<LeafRestriction> CompressedFactor::restricted(std::vector<char> dirty) const {
  const ClusterTree& tree = operators_->tree();
  for (int c = 0; c < tree.size(); ++c)
    if (!operators_->subtrees().isMine(c))
      dirty[c] = 0;
  std::vector<LeafRestriction> leaves(nodes_.size());
  // of each leaf, where unknowns stand
  std::vector<Index> places(operators_->size());
  for (int c = 0; c < tree.size(); ++c)
    if (tree[c].isLeaf() && dirty[c] != 0) {
      const std::vector<Index>& active = operators_->part(c).active;
      LeafRestriction& leaf = leaves[c];
      for (std::size_t i = 0; i < active.size(); ++i)
        if (restriction_.held[active[i]] == 0) {
          places[active[i]] = static_cast<Index>(leaf.kept.size());
          leaf.kept.push_back(static_cast<Index>(i));
        } else {
          places[active[i]] = static_cast<Index>(i);
        }
    }
  const auto requireLeaf = [&](Index unknown, std::size_t c) {
    if (operators_->leafOf(unknown) != static_cast<int>(c))
      throw std::logic_error(
          "a restriction of the compressed system connects unknowns of two leaves");
  };
  for (const auto& [follower, leader, factor] : restriction_.followers) {
    const std::size_t c = operators_->leafOf(follower);
    requireLeaf(leader, c);
    if (dirty[c] != 0 && restriction_.held[leader] == 0)
      leaves[c].followers.push_back({places[follower], places[leader], factor});
  }
  const auto add = [&](const Entry& entry) {
    const std::size_t c = operators_->leafOf(entry.row);
    requireLeaf(entry.column, c);
    if (dirty[c] != 0 && restriction_.held[entry.row] == 0 &&
        restriction_.held[entry.column] == 0)
      leaves[c].added.push_back({places[entry.row], places[entry.column], entry.value});
  };
  std::for_each(restriction_.entries.begin(), restriction_.entries.end(), add);
  for (const Index i : operators_->springUnknowns())
    add({i, i, 1});
  return leaves;
}

EliminatedCluster CompressedFactor::eliminated(int c, LeafRestriction restriction,
                                               Response& response) const {
  const Cluster& cluster = operators_->tree()[c];
  const ClusterPart& part = operators_->part(c);
  const bool isNarrowed = c == top_ && top_ != 0;
  if (cluster.isLeaf())
    return {part, std::move(restriction), isNarrowed ? *whole_ : part.block, response};
  const int first = cluster.children[0];
  const int second = cluster.children[1];
  if (node(first).isSilent() && node(second).isSilent())
    return EliminatedCluster::silent();
  if (isNarrowed)
    return {part, *responses_[first], *responses_[second], *whole_};
  return {part, responses_[first], responses_[second], response};
}

void CompressedFactor::eliminate(const std::vector<char>& dirty) {
  const BlasThreads serial(1);
  const ClusterTree& tree = operators_->tree();
  std::vector<LeafRestriction> leaves = restricted(dirty);
  std::atomic<bool> fails = false;
  std::string failure;
  std::mutex failing;
  // an LU factor, the answers to a skeleton and what they do outside
  const auto work = [&](int cluster) {
    const auto n = static_cast<double>(operators_->part(cluster).active.size());
    return workOfFlops(5 * n * n * n);
  };
  const auto visit = [&](int cluster) {
    if (fails)
      return;
    try {
      Response response;
      nodes_[cluster] = std::make_shared<const EliminatedCluster>(
          eliminated(cluster, std::move(leaves[cluster]), response));
      responses_[cluster] = std::make_shared<const Response>(std::move(response));
    } catch (const NumericalError& error) {
      const std::lock_guard<std::mutex> lock(failing);
      failure = error.what();
      fails = true;
    }
  };
  upwards(tree, operators_->subtrees(), dirty, work, visit,
          [&] { exchangeResponses(dirty, failure); });
  if (fails)  // of what is everybody's, or of one process
    throw NumericalError(failure);
  if (top_ == 0)
    addBorder();
}

// What the processes have eliminated of the roots of their subtrees.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): one exchange
void CompressedFactor::exchangeResponses(const std::vector<char>& dirty,
                                         const std::string& failure) {
  const Subtrees& subtrees = operators_->subtrees();
  std::vector<double> silent(nodes_.size());
  std::vector<Matrix> responses(nodes_.size());
  const auto forRoots = [&](const auto& action) {
    for (const int root : subtrees.roots())
      if (dirty[root] != 0)
        action(root, silent[root], responses[root]);
  };
  forRoots([&](int root, double& isSilent, Matrix& response) {
    const Index size = root == top_ ? 0 : operators_->skeletonOf(root);
    response = Matrix(size, size);
    if (!subtrees.isMine(root) || !failure.empty())
      return;
    isSilent = node(root).isSilent() ? 1 : 0;
    if (root != top_)
      response = this->response(root).full(size);
  });
  constexpr double kind = 4;
  subtrees.exchangeNumbers(
      kind, 0,
      [&](const auto& action) {
        forRoots([&](int root, double& isSilent, Matrix& response) {
          action(root, isSilent);
          for (Index j = 0; j < response.columns(); ++j)
            for (Index i = 0; i < response.rows(); ++i)
              action(root, response(i, j));
        });
      },
      failure);
  forRoots([&](int root, double isSilent, Matrix& response) {
    if (root != top_)  // the same on all
      responses_[root] = std::make_shared<const Response>(Response::of(response));
    if (subtrees.isMine(root))
      return;
    nodes_[root] = std::make_shared<const EliminatedCluster>(
        isSilent != 0 ? EliminatedCluster::silent() : EliminatedCluster::elsewhere());
  });
}

// Z = M - P Pᵀ + U S Uᵀ with springs P in the tree's M
void CompressedFactor::addBorder() {
  border_ = nullptr;
  const LowRank& rotations = operators_->rotations();
  std::vector<Index> sprung;
  for (const Index i : operators_->springUnknowns())
    if (restriction_.held[i] == 0)
      sprung.push_back(i);
  const Index turning = rotations.u.columns();
  const Index count = turning + static_cast<Index>(sprung.size());
  if (count == 0)
    return;
  Matrix u(operators_->size(), count);
  Matrix inverse(count, count);
  for (Index k = 0; k < turning; ++k) {
    std::copy_n(rotations.u.column(k), u.rows(), u.column(k));
    std::copy_n(rotations.inverse.column(k), turning, inverse.column(k));
  }
  for (Index k = turning; k < count; ++k) {
    u(sprung[k - turning], k) = 1;
    inverse(k, k) = -1;
  }
  Matrix right = u.copy();
  for (Index j = 0; j < count; ++j)
    for (Index i = 0; i < right.rows(); ++i)
      if (restriction_.held[i] != 0)
        right(i, j) = 0;
  Matrix answers = solveSprung(right, std::vector<char>(nodes_.size(), 1));
  border_ = std::make_shared<const Woodbury>(std::move(u), std::move(inverse),
                                             std::move(answers), compressedSystem);
}

std::vector<char> CompressedFactor::activePaths(std::vector<int> leaves) const {
  for (const Index i : operators_->springUnknowns())
    leaves.push_back(operators_->leafOf(i));
  return withoutAbove(operators_->tree().paths(leaves));
}

std::vector<char> CompressedFactor::withoutAbove(std::vector<char> clusters) const {
  for (int c = top_; c != 0;) {
    c = operators_->tree()[c].parent;
    clusters[c] = 0;
  }
  return clusters;
}

}  // namespace epafi::bem
