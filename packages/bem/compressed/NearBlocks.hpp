#pragma once

#include "bem/base/Material.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Blocks of the coupled system (see FarBlocks) for all pairs of elements of which some
/// functions are near each other, computed once and kept: by parts from the moments of a
/// tile, but where all elements of both functions are far from each other.
class NearBlocks {
 public:
  /// Of pairs with one element among the first (by element) and one among the second.
  /// Refers to the space's mesh.
  NearBlocks(const Space& space, const Lame& lame, const ClusterTree& tree,
             const std::vector<char>& first, const std::vector<char>& second);

  /// Are all functions of a pair far?  Then it is none of these.
  bool isDeep(int e, int f) const { return isDeep(e, f, offset(e, f)); }
  /// The same; `offset` is theirs.
  bool isDeep(int e, int f, Vec2 offset) const {
    const Hood& a = hoods_[e];
    const Hood& b = hoods_[f];
    const double reach =
        clearly * (a.radius + b.radius + (a.half > b.half ? a.half : b.half));
    return dot(offset, offset) >= reach * reach;
  }
  /// The middle of e less that of f; exactly the opposite of what it is from f to e.
  Vec2 offset(int e, int f) const {
    const Vec2 w = hoods_[e].middle - hoods_[f].middle;
    return dot(w, w) >= plainDistance * plainDistance ? w : mesh_.offset(e, f);
  }

  /// Row by row: functions of e by functions of f, see LocalFunctions.
  struct View {
    const double* data;
    Index nextRow;
    Index nextColumn;
    double operator()(int a, int b) const { return data[a * nextRow + b * nextColumn]; }
  };
  /// \throws std::logic_error if the pair is deep, or none of those asked for.
  View of(int e, int f) const;

 private:
  // Rounding may call elements near whose distance is the limit's, which meshes of halved
  // elements are full of; a pair beside them must not count as deep then.
  static constexpr double clearly = 1 + 1e-6;
  // From this distance on, in diameters, plain coordinates lose no digits that count.
  static constexpr double plainDistance = 1e-2;

  /// An element with its neighbours.
  struct Hood {
    Vec2 middle;        ///< as exact as its coordinates
    double radius = 0;  ///< about its middle
    double half = 0;    ///< the largest
  };
  struct Pair {
    int element;  ///< the other one, not before this
    std::size_t start;
  };

  void measure();
  /// Of clusters: about their centres.
  std::vector<Hood> around(const ClusterTree& tree) const;
  void findPairs(const ClusterTree& tree, const std::vector<char>& first,
                 const std::vector<char>& second);

  const Mesh& mesh_;
  std::vector<Hood> hoods_;
  std::vector<std::vector<Pair>> pairs_;
  std::vector<Index> sizes_;
  std::vector<double> values_;
};

}  // namespace epafi::bem
