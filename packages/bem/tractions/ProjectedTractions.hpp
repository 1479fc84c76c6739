#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/TileMoments.hpp"
#include "bem/operators/Block.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// <W φ, P̂_i e_a>_E and <(K' + 1/2) ψ, P̂_i e_a>_E on some elements E, P̂_i orthonormal on
/// E: the kernels' part of the projected tractions of [P (42)], transposed.  Column
/// lowest[k] + 2 i + a belongs to the k-th element.  i < 2 on elements that follow none of
/// the others, i = 0 on those that do.
///
/// The others are in S: P_i - P_{i-2} is a multiple of a displacement that lives on E, and
/// P_1 is in the hat between E and the element before it.
struct TractionKernels {
  std::vector<int> elements;
  std::vector<Index> start;   ///< of an element's TractionRows
  std::vector<Index> lowest;  ///< of its columns below
  /// displacements x columns; on a boundary with arcs one more, of the rotation, see
  /// withExactRotation
  Matrix hypersingular;
  Matrix adjoint;  ///< densities x columns, likewise

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

/// Fills TractionKernels: far pairs at points (FarTractionRows), near ones from the double
/// moments that V, K and W are made of, and potentials at the ends of E:
///
///   <W φ, P_i>_E = ∫ V*φ' P_i' dt - [P_i V*φ'],
///   <K'ψ, P_i e>_E = <ψ, K(P_i e)>,  K v = K_Δ v - ∫ X J v' ds + [X J v],
///
/// J v = (v₂, -v₁), X as in kernel/Elasticity.  Errors of near pairs are absolute, 1e-16 of
/// a potential of size 1.  Threads: over the elements.
class ProjectedTractions {
 public:
  ProjectedTractions(const Space& space, const Lame& lame,
                     const std::vector<int>& elements);

  /// Gives the result away.
  TractionKernels finish() { return std::move(kernels_); }

 private:
  /// What S tells of the k-th element, and what kernels have to.
  void raise(std::size_t k);

  /// Adds a block to the rows of the source's functions φ_k with φ_k' = slope P_j.
  void addHypersingular(int source, int j, Index column, const Block& block);

  /// What a near source gives to the columns first ... last - 1 of a test element, from the
  /// moments in lane 0.
  void addPair(int test, int source, Index first, Index last, const TileMoments& moments);

  const Space& space_;
  Lame lame_;
  TractionKernels kernels_;
};

}  // namespace epafi::bem
