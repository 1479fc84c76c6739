#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/space/Space.hpp"

#include <array>

namespace epafi::bem {

/// Entries of V, K + 1/2 and W of an element f with the elements of a run, by columns over the
/// run:
///
///   singleLayer(i, c)   V(·, P_i e_c on f)               densities of the run
///   doubleLayer(k, c)   (K + 1/2)(·, φ_k e_c on f)       densities of the run
///   slopeLayer(i, c)    <V*(P_i e_c on f), (·)'>         displacements of the run
///   transposed(i, c)    (K + 1/2)(P_i e_c on f, ·)       displacements of the run
///
/// W(·, φ_k e_c) is the slope of φ_k times slopeLayer(k-1, c), or (0, c) for k < 2.
/// Order of the displacements: start node and bubbles of one element after the other, then
/// the end node of the last.  Elements that the tile does not want have zeros, and so has f in
/// `transposed`, since doubleLayer contains that block.
class TileBlocks {
 public:
  TileBlocks(const Space& space, const Lame& lame);

  void evaluate(const Tile& tile, InstructionSet set = largestInstructionSet());

  int densities() const { return densityStarts_[lanes]; }
  int displacements() const { return displacementStarts_[lanes] + 2; }

  const double* singleLayer(int i, int c) const { return column(single_, 2 * i + c); }
  const double* doubleLayer(int k, int c) const { return column(double_, 2 * k + c); }
  const double* slopeLayer(int i, int c) const { return column(slopes_, 2 * i + c); }
  const double* transposed(int i, int c) const { return column(transposed_, 2 * i + c); }

  /// <V* 1, 1> of f and the element of a lane, both mapped to [-1, 1], times φ₁' = 1/2.
  Block halfSlopes(int lane) const {
    const double xy = halfSlopes_[1].lane[lane];
    return {halfSlopes_[0].lane[lane], xy, xy, halfSlopes_[2].lane[lane]};
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

  AlignedLane halfSlopes_[3] = {};
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
      {};          ///< 1 where the first, the last node ends an edge, else 0
  Index longest_;  ///< stride between columns
  Vector single_;
  Vector double_;
  Vector slopes_;
  Vector transposed_;
};

}  // namespace epafi::bem
