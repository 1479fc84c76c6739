#pragma once

#include "bem/moments/RingTile.hpp"
#include "bem/operators/PairColumns.hpp"

namespace epafi::bem {

/// Entries of a tile of solids of revolution, of whole revolutions.  [doc/theory/axisymmetric.md]
class RingBlocks final : public PairColumns {
 public:
  explicit RingBlocks(const Space& space) : PairColumns(space) {}

  /// Computes all columns.
  void evaluate(const RingTile& tile, InstructionSet set = largestInstructionSet());

  Scaled hypersingular(int k, int c) const override {
    return {column(hypersingular_, 2 * k + c), 1};
  }
  Block commonNode(int lane) const override {
    return {common_[0].lane[lane], common_[1].lane[lane], common_[2].lane[lane],
            common_[3].lane[lane]};
  }

 private:
  template <int Degree>
  class Filling;
  struct Fill;

  AlignedLane common_[4] = {};
};

/// ∫ P_i φ_k 2πr ds on an element of a solid of revolution.
Matrix ringMassOf(const Mesh& mesh, int e);

}  // namespace epafi::bem
