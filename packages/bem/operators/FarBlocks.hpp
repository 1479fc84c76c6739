#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/FarOrder.hpp"
#include "bem/moments/TileMoments.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/space/Space.hpp"

#include <array>
#include <map>
#include <vector>

namespace epafi::bem {

/// Entries of the coupled system by its kernels themselves, at Gauss points:
///
///   [ W   K'+1/2 ]        displacements φ_k, which are not differentiated,
///   [ K+1/2  -V  ]        densities P_i
///
/// of one trial element and up to eight test elements that are far from it.  W has its own
/// hypersingular kernel: by parts it would have noise of ε (r/h)², which a compression
/// takes for rank.
///
/// What a hat has on one of its elements is no entry by parts: both of its elements must
/// come from here, or none.
class FarBlocks {
 public:
  FarBlocks(const Space& space, const Lame& lame);

  /// A test element, and its middle less the trial element's.
  struct Test {
    int element = 0;
    Vec2 offset;
  };
  void evaluate(const std::vector<Test>& tests, int trial,
                InstructionSet set = largestInstructionSet());
  /// Tractions instead: rows 2 i + a, i < moments, with the first row's kernels tested by P_i e_a
  /// on each test element.
  void evaluateTractions(const std::vector<Test>& tests, int trial, int moments,
                         InstructionSet set = largestInstructionSet());

  /// K and -V of the trial element at points instead, eight in a pair of lanes: x and y less its
  /// middle.  `order`: farOrder of the nearest of them.
  void evaluateFields(const std::vector<AlignedLane>& points, int trial, int order,
                      InstructionSet set = largestInstructionSet());
  /// Their component c of a function of the trial element at the points of a pair.
  const double* field(std::size_t pair, int function, int c) const {
    const int i = function - 2 * (work_.columnDegree + 1);
    const int sum =
        i < 0 ? 3 * work_.columnDensities + 2 * function : 3 * (i / 2) + i % 2;
    return block_[pair * columns_ + sum + c].lane;
  }

  /// Of the functions a of the tests and b of the trial element, see LocalFunctions; the
  /// tests of an evaluation side by side.  Displacements and densities of a test are those
  /// of the largest degree among the tests: see densities().
  const double* lane(int a, int b) const { return block_[a * columns_ + b].lane; }
  /// Where the tests' densities begin.
  int densities() const { return 2 * work_.rowNodes; }

  struct Work {
    int rowNodes = 0;      ///< functions that see W and K'
    int rowDensities = 0;  ///< and K and V
    int columnDegree = 0;
    int columnDensities = 0;
    int outer = 0;  ///< points
    int inner = 0;
  };

 private:
  /// On the tests: φ_k up to a degree (-1: none), and densities.
  struct Functions {
    int degree = -1;
    int densities = 0;
  };

  FarOrder orderOf(const std::vector<Test>& tests, int trial) const;
  void integrate(const std::vector<Test>& tests, const Functions& rows, int trial,
                 InstructionSet set);
  void run(const Element& trial, int order, InstructionSet set);
  void sampleTests(const std::vector<Test>& tests);
  void sampleTrial(const Element& element);

  /// weightedFunctions of a rule with so many points, computed once.
  const std::vector<double>& functions(int points, int degree, int densities);

  const Space& space_;
  Lame lame_;
  std::map<std::array<int, 3>, std::vector<double>> functions_;
  Work work_;
  int columns_ = 0;                      ///< functions on the trial element, or sums
  std::vector<AlignedLane> outer_;       ///< at each point: w less y, tangent
  const double* outerValues_ = nullptr;  ///< φ_k, P_i times the rule's weight
  AlignedLane halves_{};
  std::vector<double> inner_;  ///< at each point: y, tangent
  std::vector<double> innerValues_;
  std::vector<AlignedLane> sums_;
  std::vector<AlignedLane> block_;
};

}  // namespace epafi::bem
