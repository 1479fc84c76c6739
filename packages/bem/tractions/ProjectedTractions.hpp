#pragma once

#include "bem/tractions/KernelRows.hpp"

namespace epafi::bem {

/// The kernels' part of the projected tractions of [P (42)] on some elements, i < 2 on elements
/// that follow none of the others, i = 0 on those that do.
///
/// The others are in S: P_i - P_{i-2} is a multiple of a displacement that lives on E, and
/// P_1 is in the hat between E and the element before it.
struct TractionKernels {
  std::vector<int> elements;
  std::vector<Index> start;  ///< of an element's TractionRows
  /// Columns below; on a boundary with arcs one more, of the rotation, see withExactRotation.
  KernelRows lowest;

  /// Column `column` of the TractionRows is ofStiffness · S e_displacement and multiples of
  /// earlier columns.
  struct Raised {
    struct Multiple {
      Index column;
      double factor;
    };
    Index column;
    std::vector<Multiple> earlier;
    Index displacement;
    double ofStiffness;
  };
  std::vector<Raised> raised;  ///< those that are not below, in their order
};

/// The discrete traction S_hp φ = W φ + (K' + 1/2) V⁻¹ (K + 1/2) φ on some elements, as
/// coefficients in an orthonormal basis of L²(E)² for every basis function φ.
///
/// Column `start[k] + 2 i + a` of `rows` is  ∫_E (S φ)_a P̂_i ds  for the k-th element E,
/// i from 0 to its degree p, P̂_i the orthonormal Legendre polynomials on E.  Where asked
/// for, more columns follow, up to start[k+1]: components of S φ beyond degree p, so that
///
///   ∫_E S φ · S ψ ds = Σ over all columns of E.
///
/// Rows are displacements; this is the transpose of what one would draw.
struct TractionRows {
  Matrix rows;
  std::vector<Index> start;
};

TractionKernels projectedTractions(const Space& space, const Lame& lame,
                                   const std::vector<int>& elements);

}  // namespace epafi::bem
