#pragma once

#include "bem/moments/RingTile.hpp"
#include "bem/operators/PairColumns.hpp"

namespace epafi::bem {

/// Entries of a tile of solids of revolution, of whole revolutions.  [doc/theory/axisymmetric.md]
class RingBlocks final : public PairColumns {
 public:
  RingBlocks(const Space& space, const Lame& lame) : PairColumns(space), tile_(lame) {}

  void integrate(const ElementRuns& runs, int trial, int r,
                 const ElementRange& wanted) override {
    tile_.evaluate(runs, trial, r, wanted);
  }
  /// With the radial displacements that W has beside slopes.
  double energy(int lane, const LocalField& onTrial,
                const LocalField& onLane) const override;

  Scaled hypersingular(int k, int c) const override {
    return {column(hypersingular_, k, c), 1};
  }
  double commonNode(int lane, int c, int d) const override {
    return common_[2 * d + c].lane[lane];
  }

 private:
  template <int Degree>
  class Filling;
  struct Fill;

  void fill() override;

  RingTile tile_;
  AlignedLane common_[4] = {};  ///< column by column
};

/// ∫ P_i φ_k 2πr ds on an element of a solid of revolution.
Matrix ringMassOf(const Mesh& mesh, int e);

}  // namespace epafi::bem
