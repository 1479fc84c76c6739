// Slender bodies are cut across before they are cut along.
#include "bem/compressed/Slices.hpp"

#include "bem/compressed/ClusterOrder.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace epafi {

namespace {

using bem::ClusterPlace;
using bem::Vec2;

/// [0, length] x [below, below + 1], so many elements on long sides, four on short ones.
bem::Space beam(double length, double below, int elements) {
  return bem::Space(bem::makeMesh(test::outlineOf(test::rectangle({0, below}, length, 1)),
                                  {elements, 4, elements, 4}, 1));
}

std::vector<std::pair<int, int>> sorted(const std::vector<ClusterPlace>& order) {
  std::vector<std::pair<int, int>> all;
  for (const ClusterPlace& place : order)
    all.emplace_back(place.body, place.element);
  std::sort(all.begin(), all.end());
  return all;
}

TEUCHOS_UNIT_TEST(Slices, slendernessIsPerimeterSquaredOverArea) {
  TEST_COMPARE(std::abs(bem::slenderness(beam(1, 0, 4).mesh()) - 16), <, 1e-12);
  TEST_COMPARE(std::abs(bem::slenderness(beam(50, 3, 9).mesh()) - 102 * 102 / 50.0), <,
               1e-10);
  const bem::Mesh mesh = reference::meshOf(reference::disc(4, 1), 40, 1);
  TEST_COMPARE(std::abs(bem::slenderness(mesh) - 4 * std::acos(-1.0)), <, 1e-2);
}

TEUCHOS_UNIT_TEST(Slices, stockyBodiesKeepTheirOrder) {
  const bem::Space space = beam(16, 0, 64);
  const std::vector<ClusterPlace> order = bem::clusterOrder({&space}, {});
  for (int e = 0; e < space.mesh().size(); ++e)
    TEST_EQUALITY(order[bem::at(e)].element, e);
}

TEUCHOS_UNIT_TEST(Slices, slenderBodiesAreCutAcross) {
  constexpr double length = 400;
  const bem::Space space = beam(length, 0, 800);
  const std::vector<ClusterPlace> order = bem::clusterOrder({&space}, {});
  const auto all = sorted(order);
  TEST_EQUALITY(static_cast<int>(all.size()), space.mesh().size());
  TEST_ASSERT(std::adjacent_find(all.begin(), all.end()) == all.end());
  const bem::ClusterTree tree({&space}, order, 0, 60);
  // half a slice, half a height more, and an element at each end
  for (int level = 1; level <= 4; ++level)
    for (const int c : tree.level(level))
      TEST_COMPARE(tree[c].radius, <,
                   (length / std::pow(2, level) / 2 + 2) /
                       space.mesh().outline().scaling().length);
}

/// What presses on each other is in one cluster, but for what stands across a cut.
TEUCHOS_UNIT_TEST(Slices, cutNothingThatIsLinked) {
  const bem::Space upper = beam(400, 1, 800);
  const bem::Space lower = beam(400, 0, 800);
  std::vector<bem::Link> links;
  for (int e = 0; e < 800; ++e)  // the lower one's top runs back
    links.push_back({{0, e}, {1, 804 + 799 - e}, 1.0});
  const std::vector<ClusterPlace> order = bem::clusterOrder({&upper, &lower}, links);
  TEST_EQUALITY(order.size(), 2 * 1608u);
  const bem::ClusterTree first({&upper, &lower}, order, 0, 60);
  const bem::ClusterTree second({&upper, &lower}, order, 1, 60);
  const auto at = [](const bem::ClusterTree& tree, int element, int level) {
    int c = tree.leafOf(element);
    while (tree[c].level > level)
      c = tree[c].parent;
    return c;
  };
  for (int level = 1; level <= 3; ++level) {
    int apart = 0;
    for (const bem::Link& link : links)
      apart += at(first, link.carrier.element, level) !=
                       at(second, link.opposite.element, level)
                   ? 1
                   : 0;
    TEST_COMPARE(apart, <, 1 << level);
  }
}

}  // namespace

}  // namespace epafi
