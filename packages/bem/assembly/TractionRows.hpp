#pragma once

#include "bem/assembly/SteklovPoincare.hpp"

#include <vector>

namespace epafi::bem {

/// The discrete traction S_hp φ = W φ + (K' + 1/2) V⁻¹ (K + 1/2) φ on some elements, as
/// coefficients in an orthonormal basis of L²(E)² for every basis function φ.
///
/// Column `start[k] + 2 i + a` of `rows` is  ∫_E (S φ)_a P̂_i ds  for the k-th element E,
/// i from 0 to its degree p, P̂_i the orthonormal Legendre polynomials on E.  Where asked
/// for, more columns follow, up to start[k+1]: components of S φ beyond degree p, so that
///
///   ∫_E S φ · S ψ ds = Σ over all columns of E.
///
/// Rows are displacements, mine; this is the transpose of what one would draw.
struct TractionRows {
  Matrix rows;
  std::vector<Index> start;
};

enum class TractionForm {
  Projected,  ///< only the columns up to degree p                         [P (42)]
  Exact       ///< all that matters to 1e-12 of the quadratic form         [P sec. 6]
};

/// The projected form costs dense algebra only where the assembly was asked for the
/// kernels on just these elements; else, and for the exact form, outer points are graded
/// to the ends of near elements, where S φ has logarithms; far sources take the orders of
/// design.md 3.4.  No difference quotients.
TractionRows tractionRows(const Space& space, const Lame& lame,
                          const SteklovPoincare& stiffness,
                          const std::vector<int>& elements, TractionForm form);

}  // namespace epafi::bem
