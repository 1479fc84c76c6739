// All pairs of bodies with arcs against plain quadrature in 33 digits.
#include "reference/ArcErrors.hpp"
#include "reference/SampleMeshes.hpp"

namespace epafi::reference {

TEUCHOS_UNIT_TEST(Arcs, allPairsOfABodyWithCornersAndASlit) {
  const bem::Mesh mesh = meshOf(curvedSample(), 1, 2);
  std::vector<std::pair<int, int>> pairs;
  for (int e = 0; e < mesh.size(); ++e)
    for (int f = 0; f <= e; ++f)
      pairs.emplace_back(e, f);
  testPairs(mesh, pairs, out, success);
}

}  // namespace epafi::reference
