#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

/// Displacements φ_k, then densities P_i, at the points of a rule one after the other,
/// times its weights and a scale.
inline std::vector<double> weightedFunctions(const Rule& rule, int degree, int densities,
                                             double scale) {
  const int count = degree + 1 + densities;
  std::vector<double> values(rule.points.size() * static_cast<std::size_t>(count));
  double* to = values.data();
  for (std::size_t q = 0; q < rule.points.size(); ++q, to += count) {
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
