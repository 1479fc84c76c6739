#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Matrix.hpp"
#include "bem/space/Space.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

class SteklovPoincare;

enum class TractionForm {
  Projected,  ///< L² projection to degree p                               [P (42)]
  Exact       ///< further columns, error 1e-12 of the quadratic form      [P sec. 6]
};

/// Tractions on some elements as coefficients in an orthonormal basis of L²(E)², for every basis
/// function.
///
/// Column start[k] + 2 i + a of `rows` is  ∫_E t_a P̂_i ds  for the k-th element E,
/// i = 0 ... p, its degree, P̂_i the orthonormal Legendre polynomials on E.  With
/// TractionForm::Exact columns of higher components follow, up to start[k+1], so that
///
///   ∫_E t · t ds = Σ over all columns of E,
///
/// for far elements by further P̂_i, for near ones in an orthonormal basis of the complement.
struct TractionRows {
  Matrix rows;  ///< displacements; of kernelRows displacements, then densities
  std::vector<Index> start;
};

/// The tractions W φ of displacements, then (K' + 1/2) ψ of densities, as rows: near sources in
/// closed form, at points graded or softened toward the ends of E and of the sources, where
/// tractions have logarithms; far sources by FarBlocks.
/// Threads: over the elements.
/// \param moments for each element the number of P̂_i; the exact form adds more for far sources
/// \throws InputError if an element has more densities than its degree
TractionRows kernelRows(const Space& space, const Lame& lame,
                        const std::vector<int>& elements, const std::vector<int>& moments,
                        TractionForm form);

/// The discrete traction S_hp φ = W φ + (K' + 1/2) V⁻¹ (K + 1/2) φ of displacements.
std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form);

}  // namespace epafi::bem
