#pragma once

#include "bem/base/Material.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/FarBlocks.hpp"
#include "bem/compressed/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Blocks of the coupled system (see FarBlocks) for all pairs of elements of which some
/// functions are near each other, computed once and kept: by parts from the moments of a
/// tile, but where all elements of both functions are far from each other.
class NearBlocks {
 public:
  /// Of pairs with one element among the first (by element) and one among the second.
  NearBlocks(const Space& space, const Lame& lame, const ClusterTree& tree,
             const std::vector<char>& first, const std::vector<char>& second);

  /// Are all functions of a pair far?  Then it is none of these.
  bool isDeep(int e, int f) const {
    const Hood& a = hoods_[e];
    const Hood& b = hoods_[f];
    const double reach =
        clearly * (a.radius + b.radius + (a.half > b.half ? a.half : b.half));
    const Vec2 w = a.middle - b.middle;
    return dot(w, w) >= reach * reach;
  }
  /// The middle of an element; as exact as its coordinates.
  Vec2 middle(int e) const { return hoods_[e].middle; }

  /// Row by row: functions of e by functions of f, see LocalFunctions.
  struct View {
    const double* data;
    Index nextRow;
    Index nextColumn;
    double operator()(int a, int b) const { return data[a * nextRow + b * nextColumn]; }
  };
  /// \pre the pair is not deep, and one of those asked for.
  View of(int e, int f) const;

 private:
  // Rounding may call elements near whose distance is the limit's, which meshes of halved
  // elements are full of; a pair beside them must not count as deep then.
  static constexpr double clearly = 1 + 1e-6;

  /// An element with its neighbours.
  struct Hood {
    Vec2 middle;
    double radius = 0;  ///< about its middle
    double half = 0;    ///< the largest
  };
  struct Pair {
    int element;  ///< the other one, not before this
    std::size_t start;
  };

  void measure(const Mesh& mesh);
  /// Of clusters: about their centres.
  std::vector<Hood> around(const ClusterTree& tree, const Mesh& mesh) const;
  void findPairs(const Space& space, const ClusterTree& tree,
                 const std::vector<char>& first, const std::vector<char>& second);

  std::vector<Hood> hoods_;
  std::vector<std::vector<Pair>> pairs_;
  std::vector<Index> sizes_;
  std::vector<double> values_;
};

}  // namespace epafi::bem
