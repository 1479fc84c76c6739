#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/Space.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

/// The functions that are not zero on an element, in the order of its blocks: the
/// displacements φ_k e_c, then the densities P_i e_c, components next to each other.
struct LocalFunctions {
  int displacements;  ///< 2 (p + 1)
  int densities;

  explicit LocalFunctions(const Element& element)
      : displacements(2 * (element.degree + 1)), densities(2 * element.densities) {}
  int size() const { return displacements + densities; }
};

/// An unknown of the coupled system, and where its function lives.
///
/// Unknowns are numbered: displacements as Space has them, densities, then others.
struct Unknown {
  int element = 0;      ///< the one that numbers it
  int local = 0;        ///< its function there; -1: none, see LocalCoupling
  bool isNode = false;  ///< it is also φ₁ of the element before
};

/// All of a space.
inline std::vector<Unknown> unknownsOf(const Space& space) {
  std::vector<Unknown> all(space.displacements() + space.densities());
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const LocalFunctions local(element);
    for (int c = 0; c < 2; ++c) {
      all[space.displacement(e, 0, c)] = {e, c, true};
      for (int k = 2; k <= element.degree; ++k)
        all[space.displacement(e, k, c)] = {e, 2 * k + c, false};
      for (int i = 0; i < element.densities; ++i)
        all[space.displacements() + space.density(e, i, c)] = {
            e, local.displacements + 2 * i + c, false};
    }
  }
  return all;
}

/// Further unknowns beside displacements and densities, and entries of the symmetric
/// system that are not those of boundary operators.  Both act between functions that
/// touch, and alone between bodies.
struct LocalCoupling {
  std::vector<int> elements;  ///< of each further unknown, one that it is on
  std::vector<int> bodies;    ///< and whose that is; empty: all are the first body's
  /// Of each body: what all of them do to its exact rotation less the interpolated one, where
  /// it has arcs, see Rotation; empty: nothing.
  std::vector<Vector> rotations;
  /// Unknowns are numbered body by body as unknownsOf has them, further ones behind all.  One
  /// of (i, j) and (j, i).
  std::vector<Entry> entries;
};

/// Displacements φ_k (degree -1: none), then densities P_i, at the points of a rule one after
/// the other, times its weights and a scale.
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

/// Gauss points that these functions take beside smoothOrder's on an element: the
/// polynomials' share, and where little is between the elements one that 1/w² asks for beyond
/// log w.
inline int gaussPoints(int smoothOrder, int degree, int densities) {
  constexpr int far = 4;
  return smoothOrder + (std::max(degree, densities - 1) + 1) / 2 +
         (smoothOrder > far ? 1 : 0);
}

}  // namespace epafi::bem
