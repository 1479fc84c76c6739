// Pairs with an arc, near and far, against plain quadrature in 33 digits.
#include "reference/ArcErrors.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace epafi::reference {

namespace {

using bem::Mesh;

/// The largest difference of far pairs from what near ones would be, over the largest
/// moment of the pair; NearMoments are the reference.
double differenceFarAndNear(const Mesh& mesh, int e, int f) {
  const bem::ElementRuns runs(mesh);
  bem::Tile tile(runs);
  const int r = runs.runOf(f);
  tile.evaluate(e, r, {runs[r].first, runs[r].last});
  const int lane = f - runs[r].first;
  if (!tile.isFar(lane))
    return 0;
  const auto near = std::make_unique<bem::TileMoments>();
  bem::NearMoments().evaluate(mesh, e, f, *near, 0);
  const bem::TileMoments& far = tile.moments();
  double worst = 0;
  double largest = 0;
  const auto compare = [&](const bem::TileMoments::Lane* a,
                           const bem::TileMoments::Lane* b, int at) {
    worst = std::max(worst, std::abs(a[at][lane] - b[at][0]));
    largest = std::max(largest, std::abs(b[at][0]));
  };
  for (int i = 0; i <= mesh[e].degree; ++i)
    for (int j = 0; j <= mesh[f].degree; ++j) {
      const int at = i * bem::TileMoments::stride + j;
      if (i < mesh[e].degree)
        compare(far.direct, near->direct, at);
      if (j < mesh[f].degree)
        compare(far.reverse, near->reverse, at);
      if (i == mesh[e].degree || j == mesh[f].degree)
        continue;
      compare(far.log, near->log, at);
      compare(far.along, near->along, at);
      compare(far.across, near->across, at);
    }
  return worst / largest;
}

}  // namespace

TEUCHOS_UNIT_TEST(Arcs, selfAndNeighboursOnACircle) {
  testPairs(meshOf(disc(3, 0.5), 1, 2), {{0, 0}, {1, 0}}, out, success);
  testPairs(meshOf(disc(2, 0.5), 2, 2), {{0, 1}}, out, success);
}

TEUCHOS_UNIT_TEST(Arcs, arcOnArcAtACorner) {
  testPairs(meshOf(curvedSample(), 1, 2), {{0, 0}, {1, 0}}, out, success);
}

TEUCHOS_UNIT_TEST(Arcs, areFarAsTheyAreNear) {
  for (const int degree : {1, 4, 10})
    for (const bem::Loop& loop : {disc(4, 0.5), disc(2, 0.5), curvedSample()})
      for (const int elements : {1, 2, 5}) {
        const Mesh mesh = meshOf(loop, elements, degree);
        double worst = 0;
        for (int e = 0; e < mesh.size(); ++e)
          for (int f = 0; f < mesh.size(); ++f)
            worst = std::max(worst, differenceFarAndNear(mesh, e, f));
        out << mesh.size() << " elements of degree " << degree << ": ";
        TEST_COMPARE(worst, <, 1e-12);
      }
}

}  // namespace epafi::reference
