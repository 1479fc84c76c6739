#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// LU factor of a sparse matrix that is a sum of dense parts, one after the other in a front:
///
///   an unknown is eliminated when all parts that have it are in the front,
///
/// with a pivot among rows and columns that are complete, at least a tenth of the largest entry of its
/// column; what has none waits for parts to come.  The cost is linear in the number of parts, where each
/// meets few others.                                                     [Irons 1970, Hood 1976]
class FrontalFactor {
 public:
  struct Part {
    std::vector<Index> unknowns;  ///< distinct; rows and columns alike
    Matrix entries;
  };
  /// \throws NumericalError if some unknowns have no pivot in the end
  FrontalFactor(Index size, const std::vector<Part>& parts);

  /// x := A⁻¹ x
  void solve(double* x) const;

 private:
  /// What is eliminated at once: A = L U in the front's order, `eliminated` rows and columns first.
  struct Stage {
    std::vector<Index> rows;  ///< equations, those that are eliminated first
    std::vector<Index> columns;
    Matrix lower;  ///< rows x eliminated; above and on the diagonal U
    Matrix upper;  ///< eliminated x the columns that stay
  };
  class Front;

  Index largest_ = -1;  ///< unknown
  std::vector<Stage> stages_;
};

}  // namespace epafi::bem
