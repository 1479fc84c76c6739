#include "bem/compressed/BodyShare.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Where unknowns stand in a list, -1: nowhere.
class Places {
 public:
  explicit Places(Index unknowns) : places_(unknowns, -1) {}

  Index operator[](Index unknown) const { return places_[unknown]; }
  void set(const std::vector<Index>& list) {
    for (const Index i : listed_)
      places_[i] = -1;
    listed_ = list;
    for (std::size_t i = 0; i < list.size(); ++i)
      places_[list[i]] = static_cast<Index>(i);
  }

 private:
  std::vector<Index> places_;
  std::vector<Index> listed_;
};

/// T of all, from each one's: unknowns of one body are nothing to another's skeleton.
Interpolation joinedWeights(const std::vector<BodyShare>& shares, std::size_t c,
                            const Places& places) {
  Interpolation result;
  struct Column {
    Index place;
    const double* values;
    Index rows;
    Index firstRow;
  };
  std::vector<Column> rest;
  for (const BodyShare& share : shares) {
    const ClusterPart& part = share.parts[c];
    const auto placeOf = [&](Index own) {
      return places[share.numbers[part.active[own]]];
    };
    for (std::size_t j = 0; j < part.weights.rest.size(); ++j)
      rest.push_back({placeOf(part.weights.rest[j]),
                      part.weights.weights.column(static_cast<Index>(j)),
                      part.weights.rows(), result.rows()});
    for (const Index own : part.weights.skeleton)
      result.skeleton.push_back(placeOf(own));
  }
  std::sort(rest.begin(), rest.end(),
            [](const Column& a, const Column& b) { return a.place < b.place; });
  result.weights = Matrix(result.rows(), static_cast<Index>(rest.size()));
  for (std::size_t j = 0; j < rest.size(); ++j) {
    result.rest.push_back(rest[j].place);
    std::copy_n(rest[j].values, rest[j].rows,
                result.weights.column(static_cast<Index>(j)) + rest[j].firstRow);
  }
  return result;
}

/// What all clusters have, from the leaves up.
class Joining {
 public:
  Joining(std::vector<BodyShare> shares, const std::vector<Entry>& between,
          const ClusterTree& tree, Index unknowns)
      : shares_(std::move(shares)),
        added_(unknowns),
        tree_(tree),
        places_(unknowns),
        parts_(tree.size()) {
    for (const Entry& entry : between) {
      added_[entry.row].emplace_back(entry.column, entry.value);
      added_[entry.column].emplace_back(entry.row, entry.value);
    }
  }

  std::vector<ClusterPart> take(const Subtrees& subtrees) {
    for (int c = tree_.size(); c-- > 0;) {  // children come behind their parents
      list(c);
      if (!subtrees.isMine(c))
        continue;
      places_.set(parts_[c].active);
      parts_[c].weights = joinedWeights(shares_, c, places_);
      joinBlock(c);
      addBetween(c);
      for (BodyShare& share : shares_) {
        share.parts[c].weights.weights = Matrix();
        share.parts[c].block = Matrix();
      }
    }
    return std::move(parts_);
  }

 private:
  /// The rows (k = 0) or columns (1) of a cluster's block.
  const std::vector<Index>& side(const std::vector<ClusterPart>& parts, int c,
                                 int k) const {
    return tree_[c].isLeaf() ? parts[c].active : parts[tree_[c].children[k]].skeleton;
  }

  void list(int c) {
    ClusterPart& part = parts_[c];
    for (const BodyShare& share : shares_) {
      for (const Index i : share.parts[c].skeleton)
        part.skeleton.push_back(share.numbers[i]);
      for (const Index i : share.parts[c].active)
        if (tree_[c].isLeaf())
          part.active.push_back(share.numbers[i]);
    }
    for (int k = 0; k < 2 && !tree_[c].isLeaf(); ++k)
      part.active.insert(part.active.end(), side(parts_, c, k).begin(),
                         side(parts_, c, k).end());
  }

  void joinBlock(int c) {
    const std::vector<Index>& columns = side(parts_, c, 1);
    Matrix& block = parts_[c].block;
    block = Matrix(static_cast<Index>(side(parts_, c, 0).size()),
                   static_cast<Index>(columns.size()));
    places_.set(columns);
    Index row = 0;
    for (const BodyShare& share : shares_) {
      const Matrix& own = share.parts[c].block;
      const std::vector<Index>& ownColumns = side(share.parts, c, 1);
      for (std::size_t j = 0; j < ownColumns.size(); ++j)
        std::copy_n(own.column(static_cast<Index>(j)), own.rows(),
                    block.column(places_[share.numbers[ownColumns[j]]]) + row);
      row += own.rows();
    }
  }

  void addBetween(int c) {
    const std::vector<Index>& columns = side(parts_, c, 1);
    places_.set(side(parts_, c, 0));
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (const auto& [other, value] : added_[columns[j]])
        if (places_[other] >= 0)
          parts_[c].block(places_[other], static_cast<Index>(j)) += value;
  }

  std::vector<BodyShare> shares_;
  std::vector<std::vector<std::pair<Index, double>>> added_;  ///< by column
  const ClusterTree& tree_;
  Places places_;
  std::vector<ClusterPart> parts_;
};

}  // namespace

std::vector<ClusterPart> joined(std::vector<BodyShare> shares,
                                const std::vector<Entry>& between,
                                const ClusterTree& tree, const Subtrees& subtrees,
                                Index unknowns) {
  return Joining(std::move(shares), between, tree, unknowns).take(subtrees);
}

}  // namespace epafi::bem
