#pragma once

#include "bem/base/MatrixView.hpp"

#include <vector>

namespace epafi::bem {

/// LU factorization P A = L U of a square matrix.
class LuFactor {
 public:
  /// Factor of a matrix of size zero.
  LuFactor() = default;
  explicit LuFactor(Matrix a);
  /// Factor with row equilibration, since rows of displacements and of densities differ in
  /// size.
  /// \throws NumericalError if the matrix is singular; the message has `name`
  static LuFactor ofScaledRows(Matrix a, const char* name);

  /// Are all pivots nonzero and not NaN?
  bool isRegular() const { return isRegular_; }
  /// Estimate of 1 / (|A| |A⁻¹|) in the 1-norm; 0 if a pivot is zero, 1 for size zero.
  double reciprocalCondition() const;

  /// x := A⁻¹ x, column by column.  \pre isRegular(); x has as many rows as A
  void solve(MatrixView x) const;
  void solve(Vector& x) const { solve(MatrixView(x)); }

 private:
  Matrix lu_;
  Vector scales_;  ///< row scaling; empty: none
  std::vector<int> pivots_;
  double norm_ = 0;
  bool isRegular_ = true;
};

}  // namespace epafi::bem
