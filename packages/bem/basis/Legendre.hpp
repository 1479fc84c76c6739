#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// Largest polynomial degree of an element.
constexpr int largestDegree = 25;

/// P₀(t) ... P_degree(t), written to values[0 .. degree].
inline void legendreValues(int degree, double t, double* values) {
  values[0] = 1;
  if (degree > 0)
    values[1] = t;
  for (int k = 1; k < degree; ++k)
    values[k + 1] = ((2 * k + 1) * t * values[k] - k * values[k - 1]) / (k + 1);
}

/// Local basis of displacements on [-1, 1]:
///
///   φ₀ = (1-t)/2,  φ₁ = (1+t)/2,  φ_k = (P_k - P_{k-2}) / √(2(2k-1)),  k = 2 ... degree.
///
/// φ_k' = √((2k-1)/2) P_{k-1} has unit norm in L²(-1,1).
struct DisplacementBasis {
  /// Values of φ₀ ... φ_degree at t, written to values[0 .. degree].
  static void values(int degree, double t, double* values);

  /// (degree+1) x (degree+1): column k has the Legendre coefficients of φ_k.
  static Matrix legendreCoefficients(int degree);

  /// φ_k' = slope(k) P_{k-1} for k >= 2; φ₀' = -P₀/2, φ₁' = P₀/2.
  static double slope(int k);

  /// The functions k = first ... last whose derivatives are multiples of P_j.
  struct Range {
    int first;
    int last;
  };
  static constexpr Range withDerivative(int j) {
    return j == 0 ? Range{0, 1} : Range{j + 1, j + 1};
  }
};

}  // namespace epafi::bem
