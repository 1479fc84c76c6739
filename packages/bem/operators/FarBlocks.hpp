#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/space/Space.hpp"

#include <array>
#include <memory>

namespace epafi::bem {

/// The entries of V, K and W that an element f gives with the far ones of a run, by
/// columns as long as the run, ready to be added to the matrices:
///
///   singleLayer(i, c)   V(·, P_i e_c on f)          densities of the run
///   doubleLayer(k, c)   K(·, φ_k e_c on f)          densities of the run
///   slopeLayer(i, c)    <V*(P_i e_c on f), (·)'>    displacements of the run
///   transposed(i, c)    K(P_i e_c on f, ·)          displacements of the run
///
/// W(·, φ_k e_c) is the slope of φ_k times slopeLayer(k-1, c), or (0, c) for k < 2.
/// Displacements are numbered as densities are: those of the start node and the bubbles
/// of one element after the other; then come two of the node behind the last. Lanes that
/// are not far give zeros.
class FarBlocks {
 public:
  FarBlocks(const Space& space, const Lame& lame);

  /// What evaluate() is to treat from now on.
  void setRun(const ElementRun& run);

  /// Treats a batch that ElementRuns chose from the run.  No far element of it may close
  /// its loop, since the node behind that one is numbered elsewhere.
  void evaluate(int f, const FarLanes& chosen, const FarBatch& batch,
                InstructionSet set = largestInstructionSet());

  int densities() const { return starts_[lanes]; }
  int displacements() const { return densities() + 2; }

  const double* singleLayer(int i, int c) const { return column(single_, 2 * i + c); }
  const double* doubleLayer(int k, int c) const { return column(double_, 2 * k + c); }
  const double* slopeLayer(int i, int c) const { return column(slopes_, 2 * i + c); }
  const double* transposed(int i, int c) const { return column(transposed_, 2 * i + c); }

  /// ∫∫ w/conj(w), of lanes on the edge of f, too: what is theirs of K in the ends of the
  /// edge is missing above.
  struct Phase {
    double real;
    double imag;
  };
  Phase phase(int lane) const { return {phaseReal_[lane], phaseImag_[lane]}; }

 private:
  const double* column(const Vector& columns, int k) const {
    return columns.data() + k * longest_;
  }

  const Space& space_;
  Lame lame_;
  std::array<double, largestDegree + 1> functionSlopes_{};
  std::array<int, lanes + 1> starts_{};
  std::array<int, lanes> degrees_{};
  std::array<int, lanes> edges_{};
  int runDegree_ = 0;
  Index longest_;  ///< from column to column
  alignas(64) double phaseReal_[lanes] = {};
  alignas(64) double phaseImag_[lanes] = {};
  std::unique_ptr<FarMoments> moments_;
  Vector single_;
  Vector double_;
  Vector slopes_;
  Vector transposed_;
};

}  // namespace epafi::bem
