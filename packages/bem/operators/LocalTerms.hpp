#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/operators/Block.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

/// Calls add(e, i, f, k, block) with the entries <φ_k, P_i>/2, e = f, of K + 1/2 for some
/// elements.
template <class Add>
void addHalfMass(const Mesh& mesh, const std::vector<int>& elements, const Add& add) {
  for (const int e : elements) {
    const Element& x = mesh[e];
    const Matrix coefficients = DisplacementBasis::legendreCoefficients(x.degree);
    for (int i = 0; i < std::min(x.densities, x.degree + 1); ++i)
      for (int k = 0; k <= x.degree; ++k) {
        const double mass = x.half * coefficients(i, k) / (2 * i + 1);
        add(e, i, e, k, Block{mass, 0, 0, mass});
      }
  }
}

/// Calls add with the terms of K, omitted by TileBlocks, for test and trial elements on one
/// straight edge: ∫∫ w/conj(w) dt dt = 4 τ².  They remain at the ends of the edge only.
template <class Add>
void addEdgeEnds(const Mesh& mesh, const Lame& lame, const std::vector<int>& tests,
                 const std::vector<int>& trials, const Add& add) {
  for (const int trial : trials)
    for (int k = 0; k < 2; ++k) {
      const Element& y = mesh[trial];
      if (mesh.lineOf(trial) < 0 || mesh.areOnLine(k == 0 ? y.previous : y.next, trial))
        continue;
      for (const int test : tests) {
        if (!mesh.areOnLine(test, trial))
          continue;
        const double s =
            4 * lame.mu * lame.b * mesh[test].half * DisplacementBasis::slope(k);
        const double real = s * (y.segment().tangent.x * y.segment().tangent.x -
                                 y.segment().tangent.y * y.segment().tangent.y);
        const double imag = s * 2 * y.segment().tangent.x * y.segment().tangent.y;
        add(test, 0, trial, k, Block{imag, -real, -real, -imag});
      }
    }
}

}  // namespace epafi::bem
