#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/Space.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

/// Basis functions on an element in local numbering: displacements φ_k e_c, then densities
/// P_i e_c; the components of a function follow each other.
struct LocalFunctions {
  int components;
  int displacements;  ///< components (p + 1)
  int densities;

  LocalFunctions(const Space& space, int e)
      : components(space.components()),
        displacements(components * (space.mesh()[e].degree + 1)),
        densities(components * space.mesh()[e].densities) {}
  int size() const { return displacements + densities; }
  int displacement(int k, int c) const { return components * k + c; }
  int density(int i, int c) const { return displacements + components * i + c; }
  /// Is it a component of φ_k, k = 0 or 1?
  bool isNode(int local, int k) const {
    return local >= components * k && local < components * (k + 1);
  }
};

/// An unknown of the coupled system and the support of its basis function.
///
/// Global numbering: displacements as in Space, densities, then the unknowns of LocalCoupling.
struct Unknown {
  int element = 0;      ///< element that numbers it
  int local = 0;        ///< local number on that element; -1: none, see LocalCoupling
  bool isNode = false;  ///< is also φ₁ of the previous element
};

/// All unknowns of a space.
inline std::vector<Unknown> unknownsOf(const Space& space) {
  std::vector<Unknown> all(space.displacements() + space.densities());
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const LocalFunctions local(space, e);
    for (int c = 0; c < space.components(); ++c) {
      all[space.displacement(e, 0, c)] = {e, c, true};
      for (int k = 2; k <= element.degree; ++k)
        all[space.displacement(e, k, c)] = {e, local.displacement(k, c), false};
      for (int i = 0; i < element.densities; ++i)
        all[space.displacements() + space.density(e, i, c)] = {e, local.density(i, c),
                                                               false};
    }
  }
  return all;
}

/// Additional unknowns of the symmetric coupled system (such as multipliers), and entries that
/// do not come from boundary operators.  They couple functions with common points, and
/// are the only coupling between bodies.
struct LocalCoupling {
  std::vector<int> elements;  ///< for each additional unknown, an element in its support
  std::vector<int> bodies;    ///< body of that element; empty: the first body
  /// By body with arcs: the products of the additional unknowns with its exact rotation
  /// minus the interpolated one, see Rotation; empty: zero.
  std::vector<Vector> rotations;
  /// Either (i, j) or (j, i).  Unknowns are numbered as in unknownsOf, body by body; then come
  /// the additional ones.
  std::vector<Entry> entries;
};

/// <φ_k, P_i> on an element, densities x displacements of one component.
inline Matrix massOf(const Element& element) {
  const Matrix legendre = DisplacementBasis::legendreCoefficients(element.degree);
  Matrix mass(element.densities, element.degree + 1);
  for (int i = 0; i < std::min(element.densities, element.degree + 1); ++i)
    for (int k = 0; k <= element.degree; ++k)
      mass(i, k) = 2 * element.half / (2 * i + 1) * legendre(i, k);
  return mass;
}

/// Values of φ_k (degree -1: none), then P_i, at a quadrature point, times its weight and a
/// scale; one point after the other.
inline std::vector<double> weightedFunctions(const Rule& rule, int degree, int densities,
                                             double scale) {
  const int count = degree + 1 + densities;
  std::vector<double> values(rule.points.size() * static_cast<std::size_t>(count));
  double* to = values.data();
  for (std::size_t q = 0; q < rule.points.size(); ++q, to += count) {
    if (degree > 0)
      DisplacementBasis::values(degree, rule.points[q], to);
    legendreValues(densities - 1, rule.points[q], to + degree + 1);
    for (int i = 0; i < count; ++i)
      to[i] *= scale * rule.weights[q];
  }
  return values;
}

/// Number of Gauss points for a kernel times these functions: smoothOrder for the kernel, half
/// the degree for the polynomials, and for elements at a small distance one point more,
/// since 1/w² is harder to integrate than log w.
inline int gaussPoints(int smoothOrder, int degree, int densities) {
  constexpr int far = 4;
  return smoothOrder + (std::max(degree, densities - 1) + 1) / 2 +
         (smoothOrder > far ? 1 : 0);
}

}  // namespace epafi::bem
