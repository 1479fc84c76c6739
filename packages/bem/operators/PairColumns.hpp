#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/space/Space.hpp"

#include <array>

namespace epafi::bem {

/// Entries of V, K + 1/2 and W between a trial element f and the elements of a run.  Each function
/// returns a column with one entry per function (·) of the run:
///
///   singleLayer(i, c)   V(·, P_i e_c on f)               densities of the run
///   doubleLayer(k, c)   (K + 1/2)(·, φ_k e_c on f)       densities of the run
///   hypersingular(k, c) W(·, φ_k e_c on f)               displacements of the run
///   transposed(i, c)    (K + 1/2)(P_i e_c on f, ·)       displacements of the run
///
/// Displacements are ordered by elements, each with its start node and bubbles; the end node of
/// the last element follows.  Entries of elements that are not asked for are zero.  So are
/// those of f in `transposed`, since doubleLayer contains that block.
class PairColumns {
 public:
  virtual ~PairColumns() = default;

  int trial() const { return trial_; }
  /// Length of a column over the densities, over the displacements.
  int densities() const { return densityStarts_[lanes]; }
  int displacements() const { return displacementStarts_[lanes] + 2; }

  const double* singleLayer(int i, int c) const { return column(single_, 2 * i + c); }
  const double* doubleLayer(int k, int c) const { return column(double_, 2 * k + c); }
  const double* transposed(int i, int c) const { return column(transposed_, 2 * i + c); }
  /// A column times a number.
  struct Scaled {
    const double* column;
    double scale;
  };
  virtual Scaled hypersingular(int k, int c) const = 0;

  /// W(φ₁ e_c on f, φ₀ e_d of the element of a lane), which share their node; rows c, columns d.
  virtual Block commonNode(int lane) const = 0;

 protected:
  explicit PairColumns(const Space& space);
  PairColumns(const PairColumns&) = default;
  PairColumns(PairColumns&&) = default;
  PairColumns& operator=(const PairColumns&) = delete;
  PairColumns& operator=(PairColumns&&) = delete;

  /// \return whether it is another one
  bool setRun(const ElementLanes& run, int trial);
  /// Adds half of <P_i, φ_k> on f, densities x displacements of one component.
  void addHalf(const Matrix& mass);
  int lastLane() const { return run_->last - run_->first - 1; }
  const double* column(const Vector& columns, int k) const {
    return columns.data() + k * longest_;
  }

  const Space& space_;
  int trial_ = 0;
  const ElementLanes* run_ = nullptr;
  std::array<double, largestDegree + 1> functionSlopes_{};
  std::array<int, lanes + 1> densityStarts_{};
  std::array<int, lanes + 1> displacementStarts_{};
  std::array<int, lanes> densityCounts_{};
  std::array<int, lanes> degrees_{};
  Index longest_;  ///< stride between columns
  Vector single_;
  Vector double_;
  Vector hypersingular_;
  Vector transposed_;
};

/// Where the functions of the lanes stand in a column of the run; Degree 1: all lanes
/// have one, and every start is 2 lane.
template <int Degree>
struct ColumnNumbering {
  const int* starts;  ///< of the lanes, and behind the last
  const int* counts;  ///< of the lanes, 0 beyond the last
  int last;           ///< lane

  /// Writes the function j of every lane that has it.
  EPAFI_INLINE void put(const Pack& x, const Pack& y, int j, double* to) const {
    if (Degree == 1) {
      interleave(x, y, to);
      return;
    }
    for (int lane = 0; lane < lanes; ++lane)
      if (j < counts[lane]) {
        to[starts[lane] + 2 * j] = x[lane];
        to[starts[lane] + 2 * j + 1] = y[lane];
      }
  }

  /// Writes the functions of the nodes, by what every lane gives to the node before it
  /// and to the one behind it.
  EPAFI_INLINE void putNodes(const Pack& beforeX, const Pack& beforeY,
                             const Pack& behindX, const Pack& behindY, double* to) const {
    Pack x;
    Pack y;
    shiftUp(behindX, x);
    shiftUp(behindY, y);
    put(beforeX + x, beforeY + y, 0, to);
    to[starts[lanes]] = behindX[last];
    to[starts[lanes] + 1] = behindY[last];
  }
};

}  // namespace epafi::bem
