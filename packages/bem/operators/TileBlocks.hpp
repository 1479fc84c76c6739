#pragma once

#include "bem/moments/Tile.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/operators/PairColumns.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

/// Entries of a tile of plane bodies.
class TileBlocks final : public PairColumns {
 public:
  TileBlocks(const Space& space, const Lame& lame);

  /// Computes all columns.
  void evaluate(const Tile& tile, InstructionSet set = largestInstructionSet());

  /// By <V*(P_i e_c on f), (·)'>, V* the kernel of W, P_i that of φ_k'.
  Scaled hypersingular(int k, int c) const override {
    return {column(hypersingular_, 2 * std::max(k - 1, 0) + c), functionSlopes_[at(k)]};
  }
  const double* transposed(int i, int c) const { return column(transposed_, 2 * i + c); }

  Block commonNode(int lane) const override {
    const double xy = halfSlopes_[1].lane[lane];
    return -functionSlopes_[1] *
           Block{halfSlopes_[0].lane[lane], xy, xy, halfSlopes_[2].lane[lane]};
  }

 private:
  struct Work;
  template <int Degree, int Rows>
  class Filling;
  struct Fill;

  void setRun(const ElementLanes& run, int trial);

  AlignedLane halfSlopes_[3] = {};  ///< <V* 1, 1> of f and the lanes, times φ₁' = 1/2
  Lame lame_;
  std::array<int, lanes> lines_{};  ///< Mesh::lineOf
  AlignedLane endsEdge_[2] =
      {};  ///< of the first, of the last node: 1 if it ends an edge, else 0
};

}  // namespace epafi::bem
