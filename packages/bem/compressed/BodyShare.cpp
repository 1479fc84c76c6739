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

}  // namespace

std::vector<ClusterPart> joined(std::vector<BodyShare> shares,
                                const std::vector<LocalCoupling::Entry>& between,
                                const ClusterTree& tree, const Subtrees& subtrees,
                                Index unknowns) {
  std::vector<std::vector<std::pair<Index, double>>> added(unknowns);
  for (const LocalCoupling::Entry& entry : between) {
    added[entry.row].emplace_back(entry.column, entry.value);
    added[entry.column].emplace_back(entry.row, entry.value);
  }
  Places places(unknowns);
  std::vector<ClusterPart> parts(tree.size());
  // from the leaves up: children come behind their parents
  for (std::size_t c = parts.size(); c-- > 0;) {
    const Cluster& cluster = tree[static_cast<int>(c)];
    const auto child = [&](auto& all, int k) -> auto& {
      return all[cluster.children[k]];
    };
    ClusterPart& part = parts[c];
    for (const BodyShare& share : shares) {
      for (const Index i : share.parts[c].skeleton)
        part.skeleton.push_back(share.numbers[i]);
      for (const Index i : share.parts[c].active)
        if (cluster.isLeaf())
          part.active.push_back(share.numbers[i]);
    }
    for (int k = 0; k < 2 && !cluster.isLeaf(); ++k)
      part.active.insert(part.active.end(), child(parts, k).skeleton.begin(),
                         child(parts, k).skeleton.end());
    if (!subtrees.isMine(static_cast<int>(c)))
      continue;
    places.set(part.active);
    part.weights = joinedWeights(shares, c, places);

    const std::vector<Index>& rows =
        cluster.isLeaf() ? part.active : child(parts, 0).skeleton;
    const std::vector<Index>& columns =
        cluster.isLeaf() ? part.active : child(parts, 1).skeleton;
    part.block =
        Matrix(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
    places.set(columns);
    Index row = 0;
    for (const BodyShare& share : shares) {
      const ClusterPart& own = share.parts[c];
      const std::vector<Index>& ownColumns =
          cluster.isLeaf() ? own.active : child(share.parts, 1).skeleton;
      for (std::size_t j = 0; j < ownColumns.size(); ++j)
        std::copy_n(own.block.column(static_cast<Index>(j)), own.block.rows(),
                    part.block.column(places[share.numbers[ownColumns[j]]]) + row);
      row += own.block.rows();
    }
    places.set(rows);
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (const auto& [other, value] : added[columns[j]])
        if (places[other] >= 0)
          part.block(places[other], static_cast<Index>(j)) += value;
    for (BodyShare& share : shares) {
      share.parts[c].weights.weights = Matrix();
      share.parts[c].block = Matrix();
    }
  }
  return parts;
}

}  // namespace epafi::bem
