// Searches along boundaries.
#include "bem/geometry/CurveTree.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace epafi {

namespace {

using bem::Curve;
using bem::CurveTree;
using bem::Disc;
using bem::Vec2;

const double pi = std::acos(-1.0);

/// A star of segments and arcs, each turned to the other side than the one before.
std::vector<Curve> star(int points) {
  std::vector<Curve> curves;
  const auto corner = [points](int k) {
    const double radius = k % 2 == 0 ? 1 : 1 - 2.0 / points;
    return Vec2{radius * std::cos(2 * pi * k / points),
                radius * std::sin(2 * pi * k / points)};
  };
  for (int k = 0; k < points; ++k)
    curves.emplace_back(corner(k), corner((k + 1) % points), 0.2 * (k % 3 - 1));
  return curves;
}

TEUCHOS_UNIT_TEST(CurveTree, searchesFindWhatIsNearInOrder) {
  for (const int count : {1, 2, 3, 13, 64, 100}) {
    const CurveTree tree(star(count));
    for (const Disc& disc : {Disc{{0.7, 0.1}, 0.1}, Disc{{-0.2, 0.9}, 0.3},
                             Disc{{3, 0}, 1}, Disc{{0, 0}, 2}}) {
      std::vector<std::size_t> found;
      tree.search([&](const Disc& other) { return other.isNear(disc); },
                  [&](std::size_t k) { found.push_back(k); });
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < tree.curves().size(); ++k)
        if (discOf(tree.curves()[k]).isNear(disc))
          expected.push_back(k);
      TEST_ASSERT(found == expected);
    }
  }
  CurveTree().search([](const Disc&) { return true; },
                     [&](std::size_t) { TEST_ASSERT(false); });
}

TEUCHOS_UNIT_TEST(CurveTree, theNearestPlaceIsTheNearest) {
  for (const int count : {2, 3, 13, 100}) {
    const CurveTree tree(star(count));
    for (int k = 0; k < 200; ++k) {
      const Vec2 x{1.5 * std::cos(0.37 * k), 1.5 * std::cos(0.53 * k + 1)};
      double expected = 1e300;
      for (const Curve& curve : tree.curves())
        expected = std::min(expected, curve.distance(x));
      const CurveTree::Foot foot = tree.nearest(x);
      TEST_COMPARE(std::abs(foot.distance - expected), <, 1e-14);
      TEST_COMPARE(std::abs(norm(x - tree.curves()[foot.curve].point(foot.t)) - expected),
                   <, 1e-14);
    }
  }
}

/// No disc leaves out a point of its curves.
TEUCHOS_UNIT_TEST(CurveTree, discsContainTheirCurves) {
  const CurveTree tree(star(37));
  for (std::size_t k = 0; k < tree.curves().size(); ++k)
    for (const double t : {-1.0, -0.3, 0.5, 1.0}) {
      const Vec2 x = tree.curves()[k].point(t);
      bool found = false;
      tree.search(
          [x](const Disc& disc) {
            return disc.isNear({x, 0}, 1e-15);
          },
          [&](std::size_t i) { found = found || i == k; });
      TEST_ASSERT(found);
    }
}

/// Of 256 times as many curves a search looks at a few discs more.
TEUCHOS_UNIT_TEST(CurveTree, searchesLookAtFewDiscs) {
  const auto looks = [](int count) {
    const CurveTree tree(star(count));
    int discs = 0;
    tree.search(
        [&](const Disc& disc) {
          ++discs;
          return disc.isNear({tree.curves()[0].point(0), 0});
        },
        [](std::size_t) {});
    return discs;
  };
  TEST_COMPARE(looks(1 << 14), <, looks(1 << 6) + 8 * 8);
}

/// So does one from a place whose reach falls to what it finds.
TEUCHOS_UNIT_TEST(CurveTree, approachesLookAtFewCurves) {
  const auto looks = [](int count) {
    const CurveTree tree(star(count));
    const Vec2 x{0.9, 0.8};
    double reach = 1e300;
    int curves = 0;
    tree.approach(
        x, [&] { return reach; },
        [&](std::size_t k) {
          ++curves;
          reach = std::min(reach, norm(x - tree.curves()[k].point(0)));
        });
    return curves;
  };
  TEST_COMPARE(looks(1 << 14), <, looks(1 << 6) + 64);
}

}  // namespace

}  // namespace epafi
