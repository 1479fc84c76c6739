#pragma once

#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/RingKernels.hpp"

namespace epafi::bem {

/// Moments for V, K and W of solids of revolution, of a trial element E and eight test elements F,
/// one in each lane: double integrals of the kernels k of RingKernels,
///
///   (k, i, j) = ∫∫ k(x, y) P_i(x) P_j(y),   x on E, y on F, both mapped to [-1, 1],
///
/// i <= d_E, j <= d_F, d the number of Legendre polynomials of the densities.  Elements on the axis
/// have no moments.
///
/// Large: use one object per thread.
class RingTile {
 public:
  /// \param more  polynomials on test elements, in addition to j <= d_F
  explicit RingTile(const Lame& lame, int more = 0) : lame_(lame), more_(more) {}

  /// Computes the moments of a trial element with the wanted elements of run r.  Those of elements
  /// that are not wanted are finite and meaningless.  Refers to the runs.
  void evaluate(const ElementRuns& runs, int trial, int r, const ElementRange& wanted);

  /// Number of polynomials on test elements.
  int columns() const { return columns_; }
  int columnsOf(const ElementLanes& run) const {
    return std::min(std::max(run.densities, run.degree) + 1 + more_, largestMoment + 1);
  }
  const RingLame& lame() const { return lame_; }
  int trial() const { return trial_; }
  const ElementLanes& run() const { return *run_; }
  bool isWanted(int lane) const {
    return wanted_.contain(run_->first + lane) && !onAxis_[lane];
  }

  /// Of eight test elements.
  EPAFI_INLINE const double* at(int kernel, int i, int j) const {
    return moments_[position(kernel, i, j)].lane;
  }

 private:
  friend struct FarRings;
  friend struct NearRings;
  EPAFI_INLINE std::size_t position(int kernel, int i, int j) const {
    return static_cast<std::size_t>((kernel * rows_ + i) * columns_ + j);
  }
  void far(const Mesh& mesh, const ElementLanes& chosen);
  void near(const Mesh& mesh, int e, int lane);

  RingLame lame_;
  int more_;
  int trial_ = 0;
  const ElementLanes* run_ = nullptr;
  ElementRange wanted_;
  bool onAxis_[lanes] = {};
  int rows_ = 0;  ///< numbers of polynomials
  int columns_ = 0;
  std::vector<AlignedLane> moments_;
  std::vector<AlignedLane> sums_;  ///< near() adds up here
};

}  // namespace epafi::bem
