#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/kernel/Laplace.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/operators/PairColumns.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

/// Entries of a tile of plane bodies, of a family whose blocks are sums of the moments of Tile:
///
///   Family::components
///   singleLayer(log, phase, whole)    block of V, components x components
///   slopes(log, phase, whole)         of V*, W v = -d/ds V* dv/ds
///   doubleLayer(log, phase, laplace)  of K, `log` and `phase` with the derivative of φ_k, `laplace` its
///                                     double layer of Laplace
///   energy(p, q, log, phase, whole, isSlope)  p·V q or p·V* q of two coefficients
///
/// KelvinMoments, LaplaceMoments.
template <class Family>
class TileBlocks final : public PairColumns {
 public:
  TileBlocks(const Space& space, const Family& family);

  void integrate(const ElementRuns& runs, int trial, int r,
                 const ElementRange& wanted) override {
    tile_.evaluate(runs, trial, r, wanted);
  }
  double energy(int lane, const LocalField& onTrial,
                const LocalField& onLane) const override;

  /// By <V*(P_i e_c on f), (·)'>, P_i that of φ_k'.
  Scaled hypersingular(int k, int c) const override {
    return {column(hypersingular_, std::max(k - 1, 0), c), functionSlopes_[at(k)]};
  }
  double commonNode(int lane, int c, int d) const override {
    return -functionSlopes_[1] * halfSlopes_[Family::components * d + c].lane[lane];
  }

 private:
  struct Work;
  template <int Degree, int Rows>
  class Filling;
  struct Fill;

  void setRun(const ElementLanes& run, int trial);
  void fill() override;

  Family family_;
  Tile tile_;
  /// <V* 1, 1> of f and the lanes, times φ₁' = 1/2, column by column
  AlignedLane halfSlopes_[Family::components * Family::components] = {};
  std::array<int, lanes> lines_{};  ///< Mesh::lineOf
  AlignedLane endsEdge_[2] =
      {};  ///< of the first, of the last node: 1 if it ends an edge, else 0
};

extern template class TileBlocks<KelvinMoments>;
extern template class TileBlocks<LaplaceMoments>;

}  // namespace epafi::bem
