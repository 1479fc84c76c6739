#pragma once

#include "bem/compressed/ClusterTree.hpp"
#include "bem/operators/Kernel.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Stored blocks of the coupled system (see FarBlocks) for all pairs of elements that are not
/// fully far: integrated by parts from the moments of a tile, except entries of two functions
/// whose supports are far from each other.
class NearBlocks {
 public:
  /// Computes the pairs of an element in `first` and one in `second` (flags by element).
  /// Refers to the space.
  NearBlocks(const Space& space, const Kernel& kernel, const ClusterTree& tree,
             const std::vector<char>& first, const std::vector<char>& second);

  /// Are all functions of e far from all functions of f?  Such a pair has no block here.
  bool isFullyFar(int e, int f) const { return isFullyFar(e, f, offset(e, f)); }
  /// \param offset offset(e, f)
  bool isFullyFar(int e, int f, Vec2 offset) const {
    const Hood& a = hoods_[e];
    const Hood& b = hoods_[f];
    const double reach =
        clearly * (a.radius + b.radius + (a.half > b.half ? a.half : b.half));
    return dot(offset, offset) >= reach * reach;
  }
  /// Midpoint of e minus midpoint of f; offset(f, e) = -offset(e, f) exactly.
  Vec2 offset(int e, int f) const {
    const Vec2 w = hoods_[e].middle - hoods_[f].middle;
    return dot(w, w) >= plainDistance * plainDistance ? w : mesh_.offset(e, f);
  }

  /// A block: functions of e x functions of f, see LocalFunctions.
  struct View {
    const double* data;
    Index nextRow;
    Index nextColumn;
    double operator()(int a, int b) const { return data[a * nextRow + b * nextColumn]; }
  };
  /// \throws std::logic_error if the pair is fully far or was not requested
  View of(int e, int f) const;

 private:
  // Meshes of halved elements have many pairs exactly at the limit distance, which rounding may
  // make near; the factor prevents that their neighbours count as fully far.
  static constexpr double clearly = 1 + 1e-6;
  // From this distance on (in diameters) differences of coordinates are accurate enough.
  static constexpr double plainDistance = 1e-2;

  /// An element with its neighbours.
  struct Hood {
    Vec2 middle;        ///< rounded coordinates
    double radius = 0;  ///< about `middle`
    double half = 0;    ///< the largest half length
  };
  struct Pair {
    int element;  ///< number of the other element, at least that of this one
    std::size_t start;
  };

  void measure();
  /// By cluster: circle about its centre.
  std::vector<Hood> around(const ClusterTree& tree) const;
  void findPairs(const ClusterTree& tree, const std::vector<char>& first,
                 const std::vector<char>& second);

  const Space& space_;
  const Mesh& mesh_;
  std::vector<Hood> hoods_;
  std::vector<std::vector<Pair>> pairs_;
  std::vector<Index> sizes_;
  std::vector<double> values_;
};

}  // namespace epafi::bem
