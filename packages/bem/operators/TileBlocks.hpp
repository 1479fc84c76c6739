#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/space/Space.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

/// Entries of V, K + 1/2 and W between the trial element f of a tile and the elements of its run.
/// Each function returns a column with one entry per function (·) of the run:
///
///   singleLayer(i, c)   V(·, P_i e_c on f)               densities of the run
///   doubleLayer(k, c)   (K + 1/2)(·, φ_k e_c on f)       densities of the run
///   hypersingular(k, c) W(·, φ_k e_c on f)               displacements of the run
///   transposed(i, c)    (K + 1/2)(P_i e_c on f, ·)       displacements of the run
///
/// Displacements are ordered by elements, each with its start node and bubbles; the end node of
/// the last element follows.  Entries of elements that the tile does not contain (isWanted) are
/// zero.  So are those of f in `transposed`, since doubleLayer contains that block.
class TileBlocks {
 public:
  TileBlocks(const Space& space, const Lame& lame);

  /// Computes all columns.
  void evaluate(const Tile& tile, InstructionSet set = largestInstructionSet());

  /// Length of a column over the densities, over the displacements.
  int densities() const { return densityStarts_[lanes]; }
  int displacements() const { return displacementStarts_[lanes] + 2; }

  const double* singleLayer(int i, int c) const { return column(single_, 2 * i + c); }
  const double* doubleLayer(int k, int c) const { return column(double_, 2 * k + c); }
  /// A column times a number.
  struct Scaled {
    const double* column;
    double scale;
  };
  /// By <V*(P_i e_c on f), (·)'>, V* the kernel of W, P_i that of φ_k'.
  Scaled hypersingular(int k, int c) const {
    return {column(slopes_, 2 * std::max(k - 1, 0) + c), functionSlopes_[at(k)]};
  }
  const double* transposed(int i, int c) const { return column(transposed_, 2 * i + c); }

  /// W(φ₁ e_c on f, φ₀ e_d of the element of a lane), which share their node.
  Block commonNode(int lane) const {
    const double xy = halfSlopes_[1].lane[lane];
    return -functionSlopes_[1] *
           Block{halfSlopes_[0].lane[lane], xy, xy, halfSlopes_[2].lane[lane]};
  }

 private:
  struct Work;
  template <int Degree, int Rows>
  class Filling;
  struct Fill;

  void setRun(const ElementLanes& run);
  void addHalfMass(int f);
  int lastLane() const { return run_->last - run_->first - 1; }

  const double* column(const Vector& columns, int k) const {
    return columns.data() + k * longest_;
  }

  AlignedLane halfSlopes_[3] = {};  ///< <V* 1, 1> of f and the lanes, times φ₁' = 1/2
  const Space& space_;
  Lame lame_;
  const ElementLanes* run_ = nullptr;
  std::array<double, largestDegree + 1> functionSlopes_{};
  std::array<int, lanes + 1> densityStarts_{};
  std::array<int, lanes + 1> displacementStarts_{};
  std::array<int, lanes> densityCounts_{};
  std::array<int, lanes> degrees_{};
  std::array<int, lanes> lines_{};  ///< Mesh::lineOf
  AlignedLane endsEdge_[2] =
      {};          ///< of the first, of the last node: 1 if it ends an edge, else 0
  Index longest_;  ///< stride between columns
  Vector single_;
  Vector double_;
  Vector slopes_;
  Vector transposed_;
};

}  // namespace epafi::bem
