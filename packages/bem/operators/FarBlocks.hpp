#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/simd/InstructionSet.hpp"
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
/// The part of a hat function on a single element has no entry of W by parts.  Compute both
/// elements of a hat function here, or neither.
class FarBlocks {
 public:
  FarBlocks(const Space& space, const Lame& lame);

  /// A test element; `offset` is its midpoint minus the midpoint of the trial element.
  struct Test {
    int element = 0;
    Vec2 offset;
  };
  void evaluate(const std::vector<Test>& tests, int trial,
                InstructionSet set = largestInstructionSet());
  /// Moments of the traction instead: row 2 i + a, i < moments, has the kernels of the first
  /// block row tested with P_i e_a on each test element.
  void evaluateTractions(const std::vector<Test>& tests, int trial, int moments,
                         InstructionSet set = largestInstructionSet());

  /// K and -V of the trial functions at points.  `points`: of each pack of eight points x, then y,
  /// relative to the element's midpoint.  `order`: farOrder of the nearest point.
  void evaluateFields(const std::vector<AlignedLane>& points, int trial, int order,
                      InstructionSet set = largestInstructionSet());
  /// Eight values of evaluateFields: component c of a function at the points of a pack.
  const double* field(std::size_t pair, int function, int c) const {
    const int i = function - 2 * (work_.columnDegree + 1);
    const int sum =
        i < 0 ? 3 * work_.columnDensities + 2 * function : 3 * (i / 2) + i % 2;
    return block_[pair * columns_ + sum + c].lane;
  }

  /// Entries of test function a and trial function b, see LocalFunctions; one lane for each
  /// test element.  All test elements have the functions of the largest degree among them;
  /// their densities begin at a = densities().
  const double* lane(int a, int b) const { return block_[a * columns_ + b].lane; }
  /// Local number of the first density of the test elements.
  int densities() const { return 2 * work_.rowNodes; }

  struct Work {
    int rowNodes = 0;      ///< test functions of W and K'
    int rowDensities = 0;  ///< test functions of K and V
    int columnDegree = 0;
    int columnDensities = 0;
    int outer = 0;  ///< Gauss points on the test elements
    int inner = 0;
  };

 private:
  /// Test functions: φ_k up to a degree (-1: none), and densities.
  struct Functions {
    int degree = -1;
    int densities = 0;
  };

  Nearness orderOf(const std::vector<Test>& tests, int trial) const;
  void integrate(const std::vector<Test>& tests, const Functions& rows, int trial,
                 InstructionSet set);
  void run(const Element& trial, int order, InstructionSet set);
  void sampleTests(const std::vector<Test>& tests, InstructionSet set);
  void sampleTrial(const Element& element);  ///< unless it is sampled by this rule

  /// weightedFunctions of a Gauss rule with this many points; computed once.
  const std::vector<double>& functions(int points, int degree, int densities);

  const Space& space_;
  Lame lame_;
  std::map<std::array<int, 3>, std::vector<double>> functions_;
  Work work_;
  int columns_ = 0;                      ///< functions on the trial element, or sums
  ElementLanes tests_{};                 ///< wx, wy: Test::offset
  std::vector<AlignedLane> outer_;       ///< at each point: position, tangent
  const double* outerValues_ = nullptr;  ///< φ_k, P_i times the rule's weight
  const Element* sampled_ = nullptr;     ///< the trial element of inner_
  std::vector<double> inner_;            ///< at each point: y, tangent
  std::vector<double> innerValues_;
  std::vector<AlignedLane> sums_;
  std::vector<AlignedLane> block_;
};

}  // namespace epafi::bem
