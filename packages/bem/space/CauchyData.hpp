#pragma once

#include "bem/space/LocalField.hpp"

namespace epafi::bem {

/// A displacement and a density as numbers of their own: Legendre series on the elements
/// of a mesh that they bring along.  Nothing of a space or an operator is needed to
/// compare two of them.
struct CauchyData {
  Mesh mesh;
  std::vector<LocalField> fields;  ///< one per element
};

/// Of Space::withoutRotation(u).
CauchyData makeCauchyData(const Space& space, const Vector& u, const Vector& psi);

/// Where an element of a union lies in one of its two meshes: its t in [-1, 1] is
/// middle + scale t there.
struct Origin {
  int element = 0;
  double middle = 0;
  double scale = 1;
};

/// The coarsest mesh on which all functions of two meshes of one outline live: the nodes
/// of both, on each element the larger of the two degrees.
struct UnionMesh {
  Mesh mesh;
  std::vector<Origin> first;   ///< one per element
  std::vector<Origin> second;  ///< one per element
};

/// Nodes are the same if they are closer than 1e-12 of their distance to the nearer
/// vertex: bisection from different starts leaves rounding between them.
/// \throws InputError if the outlines have different edges.
UnionMesh unite(const Mesh& first, const Mesh& second);

/// a - b on the union of their meshes, without any error but rounding.
CauchyData difference(const CauchyData& a, const CauchyData& b);

}  // namespace epafi::bem
