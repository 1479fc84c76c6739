#include "reference/PairwiseOperators.hpp"

#include "bem/moments/Tile.hpp"
#include "reference/Scatter.hpp"

#include <algorithm>
#include <memory>

namespace epafi::reference {

namespace {

void copyLane(const bem::TileMoments& tile, int lane, const bem::Element& e,
              const bem::Element& f, LaneMoments& moments) {
  const bem::Complex tangent = bem::asComplex(f.curve.frame().tangent);
  for (int i = 0; i <= e.densities; ++i)
    for (int j = 0; j <= f.densities; ++j) {
      const int at = i * bem::TileMoments::stride + j;
      moments.direct(i, j) = tile.direct[at][lane];
      moments.reverse(i, j) = tile.reverse[at][lane];
      if (i == e.densities || j == f.densities)
        continue;
      moments.log(i, j) = tile.log[at][lane];
      const bem::Complex phase = tile.phase(i, j, lane, tangent);
      moments.phaseReal(i, j) = phase.real();
      moments.phaseImag(i, j) = phase.imag();
    }
}

}  // namespace

bem::Operators pairwiseOperators(const bem::Space& space, const bem::Lame& lame) {
  const bem::Index densities = space.densities();
  const bem::Index displacements = space.displacements();
  bem::Operators out{bem::Matrix(densities, space.densities()),
                     bem::Matrix(densities, space.displacements()),
                     bem::Matrix(displacements, space.displacements()),
                     {}};
  const Scatter scatter(space, lame, out);
  const bem::Mesh& mesh = space.mesh();
  const bem::ElementRuns runs(mesh);
  bem::Tile tile(runs);
  const auto moments = std::make_unique<LaneMoments>();
  for (int e = 0; e < mesh.size(); ++e)
    for (int r = 0; r <= runs.runOf(e); ++r) {
      const bem::ElementRange wanted = {runs[r].first, std::min(runs[r].last, e + 1)};
      tile.evaluate(e, r, wanted);
      for (int f = wanted.first; f < wanted.last; ++f) {
        copyLane(tile.moments(), f - wanted.first, mesh[e], mesh[f], *moments);
        scatter.add(e, f, *moments);
      }
    }
  return out;
}

}  // namespace epafi::reference
