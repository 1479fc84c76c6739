#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/basis/Legendre.hpp"

#include <string>

namespace epafi::contact {

/// A basis of the polynomials of degree q >= 0 on [-1, 1], for one element's multiplier.
///
/// All sum to one.  The signs of the coefficients stand for the sign of the multiplier:
/// of its values at the nodes (Lagrange), everywhere (Bernstein's functions are
/// nonnegative), or of its means weighted by the displacement's functions (dual basis).
///                                                                        [P (12), (14)]
struct MultiplierBasis {
  const char* name = "";
  const char* meaning = "";
  /// The q+1 places in [-1, 1] where gap and bound of coefficient i are sampled.
  bem::Vector (*places)(int degree) = nullptr;
  /// The q+1 functions at t in [-1, 1].
  bem::Vector (*values)(int degree, double t) = nullptr;
  /// Coefficients belong to the displacement's Gauss-Lobatto nodes: the two that
  /// neighbours have at a common node are one.  Stable without stabilisation, and only
  /// without.
  bool sharesNodes = false;
  /// Coefficients are control points, no values: what is to be met is met otherwise, see
  /// boundCoefficients.
  bool controlPoints = false;
  /// Above this degree rounding spoils the coefficients; Graded hp halves elements
  /// instead of raising it.
  int largestDegree = bem::largestDegree;
  /// Largest |f| on [-1, 1] of a polynomial f with |∫ f χ_i| <= ∫ χ_i for all i: what
  /// small residuals of all coefficients leave open.  Null for values, as good as theirs.
  double (*amplification)(int degree) = nullptr;
};

/// All bases, the default first.  A new one is one line in MultiplierBasis.cpp, or added by
/// a program.
bem::Family<MultiplierBasis>& multiplierBases();

/// \throws bem::InputError naming the known bases.
const MultiplierBasis& multiplierBasis(const std::string& name);

/// The key that chooses one.
bem::SchemaRow multiplierRow();

}  // namespace epafi::contact
