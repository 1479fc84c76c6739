#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// P A = L U of a square matrix of SmallAlgebra's size.
class LuFactor {
 public:
  /// Of size zero.
  LuFactor() = default;
  explicit LuFactor(Matrix a);
  /// Of a matrix whose rows are brought to one size before pivots are sought: those of
  /// displacements and of densities differ.
  /// \throws NumericalError where it is singular; `name` is for the message.
  static LuFactor ofScaledRows(Matrix a, const char* name);

  /// Is every pivot a number other than zero?
  bool isRegular() const { return isRegular_; }
  /// 1 / (|A| |A⁻¹|) in the norm of column sums, estimated; 0 where a pivot is zero, 1 for size
  /// zero.
  double reciprocalCondition() const;

  /// x := A⁻¹ x, of each column.  \pre isRegular()
  void solve(Matrix& x) const { solve(x.data(), x.columns(), x.stride()); }
  void solve(Vector& x) const { solve(x.data(), 1, lu_.rows()); }

 private:
  void solve(double* x, Index columns, Index stride) const;

  Matrix lu_;
  Vector scales_;  ///< of the rows; empty: as they are
  std::vector<int> pivots_;
  double norm_ = 0;
  bool isRegular_ = true;
};

}  // namespace epafi::bem
