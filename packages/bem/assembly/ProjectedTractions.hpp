#pragma once

#include "bem/assembly/MyElements.hpp"
#include "bem/assembly/PairMoments.hpp"
#include "bem/base/DenseAlgebra.hpp"
#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// <W φ, P̂_i e_a>_E and <(K' + 1/2) ψ, P̂_i e_a>_E on some elements E, P̂_i orthonormal on
/// E, i <= p_E: the kernels' part of the projected tractions of [P (42)], transposed.
///
/// Column start[k] + 2 i + a belongs to the k-th element; rows are mine.
struct TractionKernels {
  std::vector<int> elements;
  std::vector<Index> start;
  Matrix hypersingular;  ///< displacements x columns
  Matrix adjoint;        ///< densities x columns
};

/// Fills TractionKernels from the pair moments of V, K and W, which the assembly has
/// anyway, and potentials at the ends of E:
///
///   <W φ, P_i>_E = ∫ V*φ' P_i' dt - [P_i V*φ'],
///   <K'ψ, P_i e>_E = <ψ, K(P_i e)>,  K v = K_Δ v - ∫ X J v' ds + [X J v],  J v = (v₂,
///   -v₁),
///
/// X as in Assembly.  Errors are absolute, 1e-16 of a potential of size 1.
class ProjectedTractions {
 public:
  ProjectedTractions(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
                     const std::vector<int>& elements);

  /// Adds what the moments of the pair (e, f) give: tests on e if it is one of the
  /// elements, and tests on f.  Calls with different e that share no node may run at the
  /// same time.
  void add(int e, int f, const PairMoments& moments);

  /// Adds the terms at the elements' ends and the half, and gives the result away.
  TractionKernels finish();

 private:
  struct Blocks;

  /// moment(i, j): test degree i on `test`, source degree j.
  template <class Moments>
  void addTest(int test, int source, const Moments& moments);
  void addEnds(std::size_t k);
  void put(int test, int i, int source, int j, const Blocks& blocks, double factor);

  const Space& space_;
  Lame lame_;
  Rows densityRows_;
  Rows displacementRows_;
  MyElements mine_;
  std::vector<Index> columnOf_;  ///< first column of an element, -1: not asked for
  TractionKernels kernels_;
};

}  // namespace epafi::bem
