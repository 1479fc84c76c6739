#pragma once

#include "bem/base/MatrixView.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/moments/ElementPotential.hpp"

#include <vector>

namespace epafi::bem {

/// ψ and u' of some states on all elements.
struct FieldSources {
  Mesh mesh;
  /// Rows: Legendre polynomials of one element after the other; columns: four numbers of each state,
  /// ψ x, ψ y, u' x, u' y.
  Matrix coefficients;
  std::vector<Index> firsts;  ///< row by element, and behind the last
  /// By order: Gauss points of one element after the other, from its midpoint.
  std::vector<std::vector<Vec2>> places;
};

/// An element far from some targets.
struct FarSource {
  int element = 0;
  int order = 0;  ///< of its Gauss rule
  Vec2 way;       ///< from its midpoint to the origin of the targets
};

/// Sums over sources at the points of one element in all states.  The integrals of 1/conj(w) and of
/// w/conj(w)² times each polynomial of a source make a column; such columns times the coefficients
/// of the states are the sums.  So what a further state costs is a matrix product.
class KernelRows {
 public:
  /// Refers to the sources.
  KernelRows(const FieldSources& sources, std::size_t targets);

  /// \param targets points relative to the origin
  void add(const FarSource& source, const std::vector<ComplexLanes>& targets);
  /// In closed form.
  void add(int source, const std::vector<TargetLanes>& targets);

  /// K' ψ + W u and d/ds (V ψ - K u) at the targets: four columns a state, x and y of both.
  /// Takes no further sources.
  Matrix equations(const Lame& lame, const std::vector<ComplexLanes>& normals);

 private:
  /// For the polynomials of an element: real and imaginary parts of both integrals at all targets,
  /// one below the other.
  MatrixView columnsOf(int source);
  void multiply();

  struct Stretch {
    Index first = 0;
    Index last = 0;
  };

  const FieldSources& sources_;
  Index packs_;
  Matrix integrals_;
  Index taken_ = 0;                 ///< columns of them
  std::vector<Stretch> stretches_;  ///< of the coefficients' rows that they belong to
  Matrix sums_;
};

}  // namespace epafi::bem
