#pragma once

#include "bem/base/Family.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/basis/Legendre.hpp"

#include <string>

namespace epafi::contact {

/// A basis of the polynomials of degree q >= 0 on [-1, 1], for one element's multiplier.
///
/// The functions sum to one.  Inequalities for coefficients replace those for the
/// multiplier: for its values at the nodes (Lagrange), everywhere (Bernstein: nonnegative
/// functions), or for its means weighted by the basis functions of the displacement (dual
/// basis).
///                                                                        [P (12), (14)]
struct MultiplierBasis {
  const char* name = "";
  const char* meaning = "";
  /// The q+1 places in [-1, 1] where gap and bound of coefficient i are sampled.
  bem::Vector (*places)(int degree) = nullptr;
  /// The q+1 functions at t in [-1, 1].
  bem::Vector (*values)(int degree, double t) = nullptr;
  /// Coefficients belong to the Gauss-Lobatto nodes of the displacement: neighbours share
  /// that of their common node.  Stable without stabilisation (Form None), which it
  /// requires.
  bool sharesNodes = false;
  /// Coefficients are control points, not values at places(); for bounds see
  /// boundCoefficients().
  bool controlPoints = false;
  /// Largest degree with accurate coefficients; above it Graded hp halves elements
  /// instead of raising the degree.
  int largestDegree = bem::largestDegree;
  /// Largest |f| on [-1, 1] of a polynomial f with |∫ f χ_i| <= ∫ χ_i for all i, the
  /// factor from residuals of coefficients to pointwise residuals.  Null for values
  /// (factor about 1).
  double (*amplification)(int degree) = nullptr;
};

/// All bases, the default first.  To add one: a line in MultiplierBasis.cpp, or add() in a
/// program.
bem::Family<MultiplierBasis>& multiplierBases();

/// \throws bem::InputError naming the known bases.
const MultiplierBasis& multiplierBasis(const std::string& name);

/// Schema row of the key Multiplier.
bem::SchemaRow multiplierRow();

}  // namespace epafi::contact
