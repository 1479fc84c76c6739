#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/base/Family.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/base/SchemaRow.hpp"
#include "bem/basis/Legendre.hpp"

#include <functional>
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

/// Factor of E_kj = χ_j(t_k): E⁻¹ values are the coefficients of the polynomial with these values
/// at `places`, q + 1 distinct ones for the basis of degree q.
/// \throws bem::NumericalError if the functions are linearly dependent
bem::LuFactor interpolation(const MultiplierBasis& basis, const bem::Vector& places);

/// Bounds of the q + 1 shear coefficients of an element, from the bound s(t) >= 0 of the
/// shear itself, t in [-1, 1]; all >= 0, in the unit of s.
///
/// The values of s at MultiplierBasis::places, unless coefficients are control points.
/// Then
///
///   c = max(0, coefficients of the polynomial that interpolates s at the Gauss-Lobatto points)
///
/// if its largest error is below that of the values at the control points and c is within
/// the range of s, or if its error is at most a quarter.  So the error is of order q + 1
/// for a smooth s (of order 2 with the values).  If s has a jump J, c is within the range
/// of s, since the error of a continuous function is at least J/2 and that of the values
/// at most J.
bem::Vector boundCoefficients(const MultiplierBasis& basis, int degree,
                              const std::function<double(double)>& bound);

}  // namespace epafi::contact
