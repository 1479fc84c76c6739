#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/space/LocalField.hpp"
#include "bem/space/Space.hpp"

#include <array>

namespace epafi::bem {

/// Entries of V, K + 1/2 and W of one family of kernels (Kernel) between a trial element f and the
/// elements of a run.  Each function returns a column with one entry per function (·) of the run:
///
///   singleLayer(i, c)   V(·, P_i e_c on f)               densities of the run
///   doubleLayer(k, c)   (K + 1/2)(·, φ_k e_c on f)       densities of the run
///   hypersingular(k, c) W(·, φ_k e_c on f)               displacements of the run
///   transposed(i, c)    (K + 1/2)(P_i e_c on f, ·)       displacements of the run
///
/// Displacements are ordered by elements, each with its start node and bubbles; the end node of
/// the last element follows.  Entries of elements that are not asked for are zero.  So are
/// those of f in `transposed`, since doubleLayer contains that block.
///
/// What a family implements: integrate(), the moments of a tile, by parts where W has none of its
/// own; fill(), the columns from these; commonNode() and energy().  Large: one object per thread.
class PairColumns {
 public:
  virtual ~PairColumns() = default;

  /// Computes all columns of a trial element with the wanted elements of run r.  Refers to the
  /// runs.
  void evaluate(const ElementRuns& runs, int trial, int r, const ElementRange& wanted) {
    integrate(runs, trial, r, wanted);
    fill();
  }
  /// The moments alone, for energy().
  virtual void integrate(const ElementRuns& runs, int trial, int r,
                         const ElementRange& wanted) = 0;
  /// <W u, v> + <V ψ, χ> of polynomials (u, ψ) on the trial element and (v, χ) on that of a lane.
  virtual double energy(int lane, const LocalField& onTrial,
                        const LocalField& onLane) const = 0;

  int components() const { return components_; }
  int trial() const { return trial_; }
  /// Length of a column over the densities, over the displacements.
  int densities() const { return densityStarts_[lanes]; }
  int displacements() const { return displacementStarts_[lanes] + components_; }

  const double* singleLayer(int i, int c) const { return column(single_, i, c); }
  const double* doubleLayer(int k, int c) const { return column(double_, k, c); }
  const double* transposed(int i, int c) const { return column(transposed_, i, c); }
  /// A column times a number.
  struct Scaled {
    const double* column;
    double scale;
  };
  virtual Scaled hypersingular(int k, int c) const = 0;

  /// W(φ₁ e_c on f, φ₀ e_d of the element of a lane), which share their node: row c, column d.
  virtual double commonNode(int lane, int c, int d) const = 0;

 protected:
  explicit PairColumns(const Space& space);
  PairColumns(const PairColumns&) = default;
  PairColumns(PairColumns&&) = default;
  PairColumns& operator=(const PairColumns&) = delete;
  PairColumns& operator=(PairColumns&&) = delete;

  virtual void fill() = 0;

  /// \return whether it is another one
  bool setRun(const ElementLanes& run, int trial);
  /// Adds half of <P_i, φ_k> on f, densities x displacements of one component.
  void addHalf(const Matrix& mass);
  int lastLane() const { return run_->last - run_->first - 1; }
  /// Of component c of a function.
  const double* column(const Vector& columns, int function, int c) const {
    return columns.data() + (components_ * function + c) * longest_;
  }
  double* first(Vector& columns, int function) const {
    return columns.data() + components_ * function * longest_;
  }

  const Space& space_;
  int components_;
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

/// Where the functions of the lanes stand in a column of the run; Degree 1: all lanes have one, and
/// every start is `components` times the lane.  With one Pack a function has one component, with
/// two x and y.
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
  EPAFI_INLINE void put(const Pack& x, int j, double* to) const {
    if (Degree == 1) {
      __builtin_memcpy(to, &x, sizeof x);
      return;
    }
    for (int lane = 0; lane < lanes; ++lane)
      if (j < counts[lane])
        to[starts[lane] + j] = x[lane];
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
  EPAFI_INLINE void putNodes(const Pack& before, const Pack& behind, double* to) const {
    Pack x;
    shiftUp(behind, x);
    put(before + x, 0, to);
    to[starts[lanes]] = behind[last];
  }
};

}  // namespace epafi::bem
