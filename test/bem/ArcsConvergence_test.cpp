// All pairs of bodies with arcs against plain quadrature in 33 digits.
#include "reference/ArcErrors.hpp"
#include "reference/SampleMeshes.hpp"

#include <cmath>
#include <memory>

namespace epafi::reference {

TEUCHOS_UNIT_TEST(Arcs, allPairsOfABodyWithCornersAndASlit) {
  const bem::Mesh mesh = meshOf(curvedSample(), 1, 2);
  std::vector<std::pair<int, int>> pairs;
  for (int e = 0; e < mesh.size(); ++e)
    for (int f = 0; f <= e; ++f)
      pairs.emplace_back(e, f);
  testPairs(mesh, pairs, out, success);
}

// Two elements that touch at both ends: lenses, a crescent, half a disc and little more.
TEUCHOS_UNIT_TEST(Arcs, allPairsOfLoopsOfTwoElements) {
  for (const auto& [first, second] :
       {std::pair(1.0, 1.0), {0.2, 0.2}, {1.0, -0.3}, {1.0, 0.05}})
    testPairs(meshOf(lens(first, second), 1, 2), {{0, 1}}, out, success);
}

// Elements of one arc see each other across its opening.
TEUCHOS_UNIT_TEST(Arcs, allPairsOfArcsOfMoreThanHalfACircle) {
  for (const double angle : {270.0, 337.0}) {
    const double bulge = std::tan(angle * std::acos(-1.0) / 720);
    const auto outline = outlineOf(lens(bulge, 1 / bulge));
    for (const int elements : {2, 3, 5}) {
      std::vector<std::pair<int, int>> pairs;
      for (int e = 0; e <= elements; ++e)
        for (int f = 0; f < e; ++f)
          pairs.emplace_back(e, f);
      testPairs(bem::makeMesh(outline, {elements, 1}, 1), pairs, out, success);
    }
  }
}

}  // namespace epafi::reference
