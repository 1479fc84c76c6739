// A problem of two bodies: what the one that carries the multiplier meets gives way, too.
// On any number of ranks.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::Index;
using bem::Vec2;
using contact::Vector;

constexpr bem::Units units{1.4142135623730951, 1};

/// A unit square with its lower side at a height; S assembled.
struct Block {
  bem::Lame lame{{1, 0.3, false}};
  bem::Space space;
  bem::SteklovPoincare stiffness;

  Block(double bottom, int across, int degree)
      : space(bem::makeMesh(test::outlineOf(test::rectangle({0, bottom}, 1, 1)),
                            {across, 4, across, 4}, degree)),
        stiffness(bem::assembleOperators(space, lame)) {}
};

double zero(Vec2) { return 0; }

/// The upper block in contact from above, with friction; `held`: clamped at its top.
contact::Conditions upper(bool held) {
  contact::Conditions conditions;
  contact::Conditions::Contact& side = conditions.contact["bottom"];
  side = {zero, contact::makeFriction("Tresca", {[](Vec2) { return 1.0; }}), "blocks"};
  side.parts = {{0, 0, 1}};
  if (held)
    conditions.dirichlet["top"] = {zero, zero};
  conditions.neumann["right"] = {[](Vec2 x) { return 0.01 * x.y; }, zero};
  return conditions;
}

contact::Conditions lower(bool held) {
  contact::Conditions conditions;
  if (held)
    conditions.dirichlet["bottom"] = {zero, zero};
  return conditions;
}

/// The upper side of a block that lies under another, however it is cut.
contact::OppositeSide upperSide(const Block& below, const Block& above) {
  const bem::Mesh& mesh = below.space.mesh();
  contact::OppositeSide side;
  side.body = 1;
  side.reach = 0.1;
  side.shift =
      1 / units.length *
      (above.space.mesh().outline().scaling().origin - mesh.outline().scaling().origin);
  for (const int e : mesh.elementsOf("top")) {
    side.curves.push_back(mesh[e].curve);
    side.elements.push_back(e);
    side.degrees.push_back(mesh[e].degree);
  }
  return side;
}

struct Two {
  contact::Problem alone;  ///< the upper block on a rigid plane
  contact::Problem both;
};

Two problems(const Block& above, const Block& below, bool held) {
  contact::Stabilization none;
  none.form = contact::Stabilization::Form::None;
  const auto& basis = contact::multiplierBasis("Gauss-Legendre-Lagrange");
  const contact::Conditions top = upper(held);
  const contact::Conditions bottom = lower(held);
  const contact::BodyInput plane{above.space, above.stiffness, above.lame, units,
                                 top,         basis,           none};
  contact::BodyInput upon = plane;
  const contact::MultiplierSpace multiplier(above.space.mesh(), basis, top);
  upon.opposite = std::make_shared<const contact::Opposite>(
      above.space.mesh(), multiplier, units.length,
      std::map<std::string, contact::OppositeSide>{{"blocks", upperSide(below, above)}});
  const contact::BodyInput carrier{below.space, below.stiffness, below.lame, units,
                                   bottom,      basis,           none};
  return {contact::ContactSystem({plane}).numbers().copy(),
          contact::ContactSystem({upon, carrier}).numbers().copy()};
}

/// The mirror image answers pressure alike, and shear with the opposite slip: together
/// twice as much, and nothing is left of what couples the two.
TEUCHOS_UNIT_TEST(Bodies, aBlockOnItsMirrorImageIsTwiceAsFlexible) {
  const auto [alone, both] = problems({0, 6, 2}, {-1, 6, 2}, true);
  const Index m = alone.flexibility.size();
  const double size = test::largest(both.flexibility.entries());
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < m; ++i) {
      const bool alike = (i < both.normals) == (j < both.normals);
      const double expected = alike ? 2 * alone.flexibility(i, j) : 0;
      TEST_COMPARE(std::abs(both.flexibility(i, j) - expected), <, 1e-12 * size);
    }
  // the load is on the upper block alone
  for (std::size_t i = 0; i < alone.offset.size(); ++i)
    TEST_COMPARE(std::abs(both.offset[i] - alone.offset[i]), <, 1e-14);
}

/// Meshes and degrees that do not match: common motions leave the contact as it is, to
/// rounding, because one rule integrates both sides exactly.
TEUCHOS_UNIT_TEST(Bodies, commonMotionsOfTheirColumnsDoNotMoveTheContact) {
  const auto [alone, both] = problems({0, 6, 2}, {-1, 7, 3}, false);
  TEST_EQUALITY(alone.rigidMotions(), 3);
  TEST_EQUALITY(both.rigidMotions(), 6);
  const double size = test::largest(both.rigid);
  // columns: (1,0), (0,1), the rotation about its centre in scaled lengths, of each block
  for (Index i = 0; i < both.flexibility.size(); ++i) {
    for (Index k = 0; k < 3; ++k)
      TEST_COMPARE(std::abs(both.rigid(i, k) - alone.rigid(i, k)), <, 1e-14);
    for (const Index k : {0, 1})
      TEST_COMPARE(std::abs(both.rigid(i, k) + both.rigid(i, 3 + k)), <, 1e-13 * size);
    // turned about its own centre, 1 apart, each leaves the other by a shift
    const double shift = 1 / units.length * both.rigid(i, 0);
    TEST_COMPARE(std::abs(both.rigid(i, 2) + both.rigid(i, 5) - shift), <, 1e-13 * size);
  }
}

/// Finer below: the flexibility of the same two blocks, to the accuracy of the meshes.
TEUCHOS_UNIT_TEST(Bodies, aFinerBlockBelowAnswersAlike) {
  const auto coarse = problems({0, 6, 2}, {-1, 6, 2}, true).both;
  const auto fine = problems({0, 6, 2}, {-1, 15, 3}, true).both;
  // under a uniform pressure: work of the mean penetration
  const auto work = [](const contact::Problem& problem) {
    Vector uniform(problem.flexibility.size(), 0.0);
    std::fill_n(uniform.begin(), problem.normals, 1.0);
    const Vector r = problem.flexibility.times(uniform);
    double sum = 0;
    for (std::size_t i = 0; i < uniform.size(); ++i)
      sum += uniform[i] * r[i];
    return sum;
  };
  TEST_FLOATING_EQUALITY(work(coarse), work(fine), 2e-3);
}

}  // namespace

}  // namespace epafi
