#pragma once

#include "bem/kernel/Laplace.hpp"
#include "bem/kernel/PointKernels.hpp"
#include "bem/kernel/RingPoints.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/space/Space.hpp"

#include <array>
#include <map>
#include <vector>

namespace epafi::bem {

/// Blocks of the coupled system, by Gauss quadrature of its kernels:
///
///   [ W   K'+1/2 ]        displacements φ_k, not differentiated,
///   [ K+1/2  -V  ]        densities P_i
///
/// for one trial element and up to eight test elements far from it.  W is integrated with
/// the hypersingular kernel: integration by parts would leave rounding errors of ε (r/h)²,
/// which increase the rank of compressed blocks.
///
/// Of any family of kernels (Kernel): FarQuadrature.
///
/// The part of a hat function on a single element has no entry of W by parts.  Compute both
/// elements of a hat function here, or neither.
class FarBlocks {
 public:
  virtual ~FarBlocks() = default;

  /// A test element; `offset` is its midpoint minus the midpoint of the trial element.
  struct Test {
    int element = 0;
    Vec2 offset;
  };
  void evaluate(const std::vector<Test>& tests, int trial);
  /// Moments of the traction instead: row (i, a), i < moments, has the kernels of the first
  /// block row tested with P_i e_a on each test element.
  void evaluateTractions(const std::vector<Test>& tests, int trial, int moments);

  /// K and -V of the trial functions at points.  `points`: of each pack of eight points x, then y,
  /// relative to the element's midpoint.  `order`: farOrder of the nearest point.
  void evaluateFields(const std::vector<AlignedLane>& points, int trial, int order);
  /// Eight values of evaluateFields: component c of a function at the points of a pack.
  const double* field(std::size_t pair, int function, int c) const {
    const int i = function - entries_.components * (work_.columnDegree + 1);
    const int column = i < 0 ? function : i;
    const int entries = i < 0 ? entries_.k : entries_.v;
    const int start = i < 0 ? entries_.v * work_.columnDensities : 0;
    // xx, xy, yy or xx, yx, xy, yy
    const int step = entries == 3 ? 1 : entries_.components;
    const int sum = start + entries * (column / entries_.components) +
                    step * (column % entries_.components);
    return block_[pair * columns_ + sum + c].lane;
  }

  /// Entries of test function a and trial function b, see LocalFunctions; one lane for each
  /// test element.  All test elements have the functions of the largest degree among them;
  /// their densities begin at a = densities().
  const double* lane(int a, int b) const { return block_[a * columns_ + b].lane; }
  /// Local number of the first density of the test elements.
  int densities() const { return entries_.components * work_.rowNodes; }

  struct Work {
    int rowNodes = 0;      ///< test functions of W and K'
    int rowDensities = 0;  ///< test functions of K and V
    int columnDegree = 0;
    int columnDensities = 0;
    int outer = 0;  ///< Gauss points on the test elements
    int inner = 0;
  };

 protected:
  /// Distinct entries of the kernels at a pair of points: components² = 1 or 4, or three of a
  /// symmetric block.
  struct Entries {
    int components;
    int v;
    int k;
    int t;
    int w;
  };
  FarBlocks(const Space& space, const Entries& entries)
      : space_(space), entries_(entries) {}
  FarBlocks(const FarBlocks&) = default;
  FarBlocks(FarBlocks&&) = default;
  FarBlocks& operator=(const FarBlocks&) = delete;
  FarBlocks& operator=(FarBlocks&&) = delete;

 private:
  /// From samples to the block.
  virtual void compute() = 0;

  /// Test functions: φ_k up to a degree (-1: none), and densities.
  struct Functions {
    int degree = -1;
    int densities = 0;
  };

  Nearness orderOf(const std::vector<Test>& tests, int trial) const;
  void integrate(const std::vector<Test>& tests, const Functions& rows, int trial);
  void run(const Element& trial, int order);
  void sampleTests(const std::vector<Test>& tests);
  void sampleTrial(const Element& element);  ///< unless it is sampled by this rule

  /// weightedFunctions of a Gauss rule with this many points; computed once.
  const std::vector<double>& functions(int points, int degree, int densities);

 protected:
  const Space& space_;
  Entries entries_;
  std::map<std::array<int, 3>, std::vector<double>> functions_;
  Work work_;
  int columns_ = 0;                 ///< functions on the trial element, or sums
  ElementLanes tests_{};            ///< wx, wy: Test::offset
  std::vector<AlignedLane> outer_;  ///< at each point: position, tangent, a ring's radius
  static constexpr int outerSize = 5;
  const double* outerValues_ = nullptr;  ///< φ_k, P_i times the rule's weight
  const Element* sampled_ = nullptr;     ///< the trial element of inner_
  /// At each point: y from the middle, tangent, and the scaled place's x, a ring's radius.
  std::vector<double> inner_;
  static constexpr int innerSize = 5;
  std::vector<double> innerValues_;
  std::vector<AlignedLane> sums_;
  std::vector<AlignedLane> block_;
};

/// FarBlocks of a family of kernels at pairs of points:
///
///   Points::components, Points::Constants
///   v, k, t, w                       packs of the distinct entries of -V, K, K' and W, column by column
///   evaluate<Division>(constants, dx, dy, tx, ty, radius, source)
///                                    w = x - y, tangent and radius in x; FarBlocks::inner_ of y
///
/// KelvinPoints, LaplacePoints, RingPoints.
template <class Points>
class FarQuadrature final : public FarBlocks {
 public:
  FarQuadrature(const Space& space, const typename Points::Constants& constants);

 private:
  struct Integrate;
  void compute() override;

  typename Points::Constants constants_;
};

extern template class FarQuadrature<KelvinPoints>;
extern template class FarQuadrature<LaplacePoints>;
extern template class FarQuadrature<RingPoints>;

}  // namespace epafi::bem
