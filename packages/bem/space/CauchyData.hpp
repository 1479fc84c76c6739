#pragma once

#include "bem/space/LocalField.hpp"

namespace epafi::bem {

/// A displacement and a density as Legendre series on the elements of a mesh; independent of
/// a Space, so that data of different meshes can be compared.
struct CauchyData {
  Mesh mesh;
  std::vector<LocalField> fields;  ///< one per element
};

/// Cauchy data of Space::withoutRotation(u) and ψ.
CauchyData makeCauchyData(const Space& space, const Vector& u, const Vector& psi);

/// Position of an element of a UnionMesh in one of the two meshes: t corresponds to
/// middle + scale t on `element`.
struct Origin {
  int element = 0;
  double middle = 0;
  double scale = 1;
};

/// The coarsest mesh that represents all functions on two meshes of one outline: the nodes
/// of both, and on each element the larger of the two degrees.
struct UnionMesh {
  Mesh mesh;
  std::vector<Origin> first;   ///< one per element
  std::vector<Origin> second;  ///< one per element
};

/// Nodes count as equal if they are closer than 1e-12 of their distance to the nearer vertex,
/// since different bisections round differently.
/// \throws InputError if the outlines have different edges
UnionMesh unite(const Mesh& first, const Mesh& second);

/// a - b on the union of their meshes, exact up to rounding.
CauchyData difference(const CauchyData& a, const CauchyData& b);

}  // namespace epafi::bem
