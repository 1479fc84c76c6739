#pragma once

#include "bem/tractions/KernelRows.hpp"

namespace epafi::bem {

/// Data for the projected tractions on some elements that are not entries of S: KernelRows for
/// i = 0, and for i = 1 unless the previous element is one of `elements`.         [P (42)]
///
/// The other moments follow from S: P_i - P_{i-2} is a multiple of a bubble function on E,
/// and P_1 of E is part of the hat function at its start node.
struct TractionKernels {
  std::vector<int> elements;
  std::vector<Index> start;  ///< TractionRows::start
  /// Lowest moments; with arcs also a last column for the rotation, see withExactRotation.
  KernelRows lowest;

  /// Column `column` of the TractionRows as ofStiffness · S e_displacement plus multiples of
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
  std::vector<Raised> raised;  ///< all other columns, ascending
};

/// The discrete traction S_hp φ = W φ + (K' + 1/2) V⁻¹ (K + 1/2) φ on some elements, as
/// coefficients in an orthonormal basis of L²(E)² for every basis function φ.
///
/// Column `start[k] + 2 i + a` of `rows` is  ∫_E (S φ)_a P̂_i ds  for the k-th element E,
/// i = 0 ... p, its degree, P̂_i the orthonormal Legendre polynomials on E.  With
/// TractionForm::Exact columns of higher components follow, up to start[k+1], so that
///
///   ∫_E S φ · S ψ ds = Σ over all columns of E.
///
/// Rows are displacements.
struct TractionRows {
  Matrix rows;
  std::vector<Index> start;
};

TractionKernels projectedTractions(const Space& space, const Lame& lame,
                                   const std::vector<int>& elements);

}  // namespace epafi::bem
