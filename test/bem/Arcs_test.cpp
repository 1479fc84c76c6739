// Pairs with an arc, near and far, against plain quadrature in 33 digits.
#include "Largest.hpp"
#include "bem/moments/NearPairs.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "reference/ArcErrors.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace epafi::reference {

namespace {

using bem::Mesh;
using bem::Tile;

/// The largest difference of a lane from a pair's moments over the largest of these.
double errorOf(const Tile& tile, int lane, const Tile& exact, const Mesh& mesh, int e,
               int f) {
  test::Largest difference;
  test::Largest size;
  for (const auto table :
       {&Tile::log, &Tile::along, &Tile::across, &Tile::direct, &Tile::reverse})
    for (int i = 0; i < mesh[e].degree + (table == &Tile::reverse ? 1 : 0); ++i)
      for (int j = 0; j < mesh[f].degree + (table == &Tile::direct ? 1 : 0); ++j) {
        const int at = i * Tile::stride + j;
        difference.take((tile.*table)[at][lane] - (exact.*table)[at][0]);
        size.take((exact.*table)[at][0]);
      }
  return difference.size() / size.size();
}

/// Of the moments of an element and the one that it ends at, from those by far more points that
/// are graded toward the corner, over the largest.
double differenceFromFiner(const Mesh& mesh, int e) {
  const int f = mesh[e].next;
  const bool isShorter = mesh[e].half <= mesh[f].half;
  const int outer = isShorter ? e : f;
  const bem::Piece& piece = mesh[isShorter ? f : e].piece;
  std::vector<bem::Feature> features;
  for (const bem::Position& end : {piece.start, piece.end}) {
    const bem::RelativeTarget seen = seenFrom(mesh, outer, {piece.edge, end, 0});
    features.push_back({seen.z.real(), std::abs(seen.b())});
  }
  const auto exact = std::make_unique<Tile>();
  bem::nearMoments(mesh, e, f, bem::gradedRule(features, 60, 1e-16), *exact, 0);
  const auto near = std::make_unique<Tile>();
  bem::nearMoments(mesh, e, f, *near, 0);
  return errorOf(*near, 0, *exact, mesh, e, f);
}

/// The largest difference of far pairs from what near ones would be, over the largest
/// moment of the pair; nearMoments are the reference.
double differenceFarAndNear(const Mesh& mesh, int e, int f) {
  const bem::ElementRuns runs(mesh);
  Tile tile;
  const int r = runs.runOf(f);
  tile.evaluate(runs, e, r, {runs[r].first, runs[r].last});
  const int lane = f - runs[r].first;
  if (!tile.isFar(lane))
    return 0;
  const auto near = std::make_unique<Tile>();
  bem::nearMoments(mesh, e, f, *near, 0);
  return errorOf(tile, lane, *near, mesh, e, f);
}

}  // namespace

TEUCHOS_UNIT_TEST(Arcs, selfAndNeighboursOnACircle) {
  testPairs(meshOf(disc(3, 0.5), 1, 2), {{0, 0}, {1, 0}}, out, success);
  testPairs(meshOf(disc(2, 0.5), 2, 2), {{0, 1}}, out, success);
}

TEUCHOS_UNIT_TEST(Arcs, thatTouchAtBothEnds) {
  testPairs(meshOf(disc(2, 0.5), 1, 1), {{0, 1}}, out, success);
  testPairs(meshOf(lens(1, 0), 1, 1), {{0, 1}}, out, success);
}

/// Its elements see each other across its opening.
TEUCHOS_UNIT_TEST(Arcs, ofAnArcOfMoreThanHalfACircle) {
  const double bulge = std::tan(3 * std::acos(-1.0) / 8);
  const auto outline = outlineOf(lens(bulge, 1 / bulge));
  testPairs(bem::makeMesh(outline, {2, 1}, 1), {{0, 1}, {0, 2}}, out, success);
}

TEUCHOS_UNIT_TEST(Arcs, arcOnArcAtACorner) {
  testPairs(meshOf(curvedSample(), 1, 2), {{0, 0}, {1, 0}}, out, success);
}

/// Where polynomials of both ask for the largest rules that there are.
TEUCHOS_UNIT_TEST(Arcs, atCornersMayHaveTheLargestDegree) {
  for (const bem::Loop& loop : {curvedSample(), disc(2, 0.5), lens(1, 0), lens(0.1, 0.2)})
    for (const int degree : {8, bem::largestDegree}) {
      const Mesh mesh = meshOf(loop, 1, degree);
      double worst = 0;
      for (int e = 0; e < mesh.size(); ++e)
        if (!mesh[e].curve.isStraight() || !mesh[mesh[e].next].curve.isStraight())
          worst = std::max(worst, differenceFromFiner(mesh, e));
      out << mesh.size() << " elements of degree " << degree << ": ";
      TEST_COMPARE(worst, <, 1e-13);
    }
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
