#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// LU of a square matrix whose rows are brought to one size before pivots are sought: those of
/// displacements and of densities differ.
class ScaledLu {
 public:
  ScaledLu() = default;
  /// \throws NumericalError where it is singular.
  explicit ScaledLu(Matrix matrix);

  /// X <- A⁻¹ X
  void solve(Matrix& x) const;

 private:
  Matrix lu_;
  Vector scales_;
  std::vector<int> pivots_;
};

}  // namespace epafi::bem
