#include "reference/ArcErrors.hpp"

#include "reference/ArcMoments.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::reference {

using bem::Mesh;
using ArcField = ArcMoments::Field;

namespace {

/// The largest error of the moments of a pair over the largest moment.
double error(const Mesh& mesh, bem::Tile& tile, const bem::ElementRuns& runs, int e,
             int f) {
  const int r = runs.runOf(f);
  tile.evaluate(runs, e, r, {runs[r].first, runs[r].last});
  const int lane = f - runs[r].first;
  const bem::Tile& m = tile;
  const int rows = mesh[e].degree;
  const int columns = mesh[f].degree;
  const ArcMoments exact(mesh, e, f, std::max(rows, columns));
  const bem::Complex tangent = bem::asComplex(mesh[f].curve.frame().tangent);
  double worst = 0;
  double largest = 0;
  const auto compare = [&](double value, double wanted) {
    worst = std::max(worst, std::abs(value - wanted));
    largest = std::max(largest, std::abs(wanted));
  };
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const int at = i * bem::Tile::stride + j;
      if (i < rows)
        compare(m.direct[at][lane], exact(ArcField::Direct, i, j));
      if (j < columns)
        compare(m.reverse[at][lane], exact(ArcField::Reverse, i, j));
      if (i == rows || j == columns)
        continue;
      compare(m.log[at][lane], exact(ArcField::Log, i, j));
      const bem::Complex phase = m.phase(i, j, lane, tangent);
      compare(phase.real(), exact(ArcField::PhaseReal, i, j));
      compare(phase.imag(), exact(ArcField::PhaseImag, i, j));
    }
  return worst / largest;
}

}  // namespace

void testPairs(const Mesh& mesh, const std::vector<std::pair<int, int>>& pairs,
               Teuchos::FancyOStream& out, bool& success) {
  const bem::ElementRuns runs(mesh);
  bem::Tile tile;
  for (const auto& [e, f] : pairs) {
    out << "elements " << e << ", " << f << ": ";
    TEST_COMPARE(error(mesh, tile, runs, e, f), <, 1e-13);
  }
}

}  // namespace epafi::reference
