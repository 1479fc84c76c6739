// What lies opposite to the contact sides of whole bodies.
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/mesh/Mesh.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/opposite/Opposite.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace epafi {

namespace {

using bem::Curve;
using bem::CurveTree;
using bem::Vec2;

const double pi = std::acos(-1.0);

bem::Loop circle(double radius, double turn) {
  bem::Loop loop;
  for (int k = 0; k < 4; ++k) {
    const double angle = turn + k * pi / 2;
    loop.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    loop.edges.emplace_back("round");
    loop.bulges.push_back(std::tan(pi / 8));
  }
  return loop;
}

const bem::Scaling tenth{{0, 0}, 10};

/// A square with a round hole of radius 1.25, a disc of radius 1 in it whose nodes are
/// elsewhere, and a condition that takes 0.01 off the gap.
struct Fit {
  bem::Mesh ring = makeMesh(
      std::make_shared<const bem::Outline>(
          bem::Loop{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {"out", "out", "out", "out"}},
          std::vector<bem::Loop>{circle(1.25, 0)}, tenth),
      {1, 1, 1, 1, 2, 2, 3, 2}, 2);
  bem::Mesh disc = makeMesh(std::make_shared<const bem::Outline>(
                                circle(1, 0.4), std::vector<bem::Loop>{}, tenth),
                            {3, 2, 1, 2}, 4);
  contact::Conditions conditions = makeConditions();
  contact::MultiplierSpace multiplier{
      ring, contact::multiplierBasis("Gauss-Legendre-Lagrange"), conditions};
  contact::Opposite facing{multiplier, tenth.length, {{"fit", oppositeSide()}}};

  static contact::Conditions makeConditions() {
    contact::Conditions conditions;
    contact::Conditions::Contact fit{[](Vec2) { return -0.01; },
                                     contact::makeFriction("None", {})};
    fit.name = "fit";
    for (int edge = 4; edge < 8; ++edge)
      fit.parts.push_back({edge, 0, 1});
    conditions.contact["round"] = fit;
    return conditions;
  }

  contact::OppositeSide oppositeSide() const {
    contact::OppositeSide side;
    side.body = 3;
    std::vector<Curve> curves;
    for (int e = 0; e < disc.size(); ++e) {
      curves.push_back(disc[e].curve);
      side.elements.push_back(e);
      side.degrees.push_back(disc[e].degree);
    }
    side.curves = CurveTree(std::move(curves));
    side.visibility = {ring.outline().curves().curves(), disc.outline().curves().curves(),
                       1e-10};
    return side;
  }
};

TEUCHOS_UNIT_TEST(Opposite, theGapIsTheDistanceAndWhatTheConditionAdds) {
  const Fit fit;
  TEST_EQUALITY(fit.multiplier.elements(0).size(), 9u);
  for (const auto& element : fit.multiplier.elements(0)) {
    TEST_EQUALITY(fit.facing.degree(element), 4);
    for (const double t : {-1.0, -0.4, 0.7}) {
      const auto point = fit.facing.at(element, t);
      TEST_FLOATING_EQUALITY(point.gap, (0.25 - 0.01) / 10, 1e-13);
      TEST_EQUALITY(point.body, 3);
      const Vec2 here = fit.ring[element.element].curve.point(t);
      const Vec2 there = fit.disc[point.element].curve.point(point.t);
      TEST_COMPARE(norm((0.8) * here - there), <, 1e-15);
    }
  }
  TEST_ASSERT(fit.facing.meetsDeformable(0));
  TEST_ASSERT(!fit.facing.meetsDeformable(3));
  TEST_ASSERT(!fit.facing.isStill());
}

/// The element opposite changes at breaks and nowhere else.
TEUCHOS_UNIT_TEST(Opposite, breaksAreTheFeetOfNodes) {
  const Fit fit;
  std::size_t count = 0;
  for (const auto& element : fit.multiplier.elements(0)) {
    const contact::Vector breaks = fit.facing.breaks(element);
    count += breaks.size();
    for (const double t : breaks)
      TEST_INEQUALITY(fit.facing.at(element, t - 1e-9).element,
                      fit.facing.at(element, t + 1e-9).element);
    for (const auto& [middle, half, opposite] : stretches(fit.facing, element))
      TEST_EQUALITY(fit.facing.at(element, middle - 0.99 * half).element,
                    fit.facing.at(element, middle + 0.99 * half).element);
  }
  TEST_EQUALITY(count, 8u);  // all nodes of the disc
}

/// Back and forth, and ∫ f ds over the ring is ∫ f stretching ds over the disc.
TEUCHOS_UNIT_TEST(Opposite, sourcesLeadBack) {
  const Fit fit;
  for (int e = 0; e < fit.disc.size(); ++e)
    for (const double t : {-0.9, 0.1, 0.8}) {
      const auto sources = fit.facing.sources(3, e, t);
      TEST_EQUALITY(sources.size(), 1u);
      TEST_FLOATING_EQUALITY(sources[0].stretching, 1.25, 1e-13);
      const auto back = fit.facing.at(*sources[0].element, sources[0].t);
      TEST_EQUALITY(back.element, e);
      TEST_COMPARE(std::abs(back.t - t), <, 1e-13);
    }
  TEST_EQUALITY(fit.facing.sources(2, 0, 0).size(), 0u);
}

/// The density of what a side sees takes part if the conditions of that body say so, and no system
/// is without it.
TEUCHOS_UNIT_TEST(Opposite, densitiesOfBothBodiesNeedTheFacingParts) {
  const Fit fit;
  const auto& basis = contact::multiplierBasis("Gauss-Legendre-Lagrange");
  contact::OppositeSide side = fit.oppositeSide();
  side.body = 1;
  for (const bool said : {false, true}) {
    contact::Conditions seen;
    for (int edge = 0; edge < 4 && said; ++edge)
      seen.facing.push_back({edge, 0, 1});
    const contact::MultiplierSpace multiplier(
        {{fit.ring, fit.conditions}, {fit.disc, seen}}, basis);
    const contact::Opposite facing(multiplier, tenth.length, {{"fit", side}});
    const bem::Space ring(fit.ring);
    const bem::Space disc = makeSpace(fit.disc, seen, {});
    const auto plain = contact::makeCouplings({&ring, &disc}, multiplier, facing);
    const auto make = [&] {
      return contact::stabilised(plain[1], disc, multiplier, 1, {}, bem::Lame({1, 0.3}),
                                 {tenth.length, 1});
    };
    if (said) {
      const contact::Coupling own = make();
      TEST_EQUALITY(own.elements.size(), static_cast<std::size_t>(fit.disc.size()));
      TEST_ASSERT(!own.weights.empty() && !own.mass.empty());
    } else {
      TEST_THROW(make(), bem::InputError);
    }
  }
}

/// What a coefficient does to one body on a translation it takes from the other one.
TEUCHOS_UNIT_TEST(Opposite, forcesOnBothBodiesBalance) {
  const Fit fit;
  const bem::Space ring(fit.ring);
  const bem::Space disc(fit.disc);
  const auto couplings =
      contact::makeCouplings({&ring, &ring, &ring, &disc}, fit.multiplier, fit.facing);
  for (const bem::Index k : {0, 1}) {
    const contact::Vector own =
        couplings[0].trace.apply(bem::columnOf(ring.rigidMotions(), k));
    const contact::Vector other =
        couplings[3].trace.apply(bem::columnOf(disc.rigidMotions(), k));
    double largest = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      TEST_COMPARE(std::abs(own[i] + other[i]), <, 1e-13);
      largest = std::max(largest, std::abs(own[i]));
    }
    TEST_COMPARE(largest, >, 1e-3);
  }
}

/// Another element of the ring on either side of them.
TEUCHOS_UNIT_TEST(Opposite, sourcesBreakWhereTheSidesElementsEnd) {
  const Fit fit;
  std::size_t count = 0;
  for (int e = 0; e < fit.disc.size(); ++e)
    for (const double t : fit.facing.sourceBreaks(3, e)) {
      if (std::abs(t) > 1 - 1e-6)
        continue;
      TEST_INEQUALITY(fit.facing.sources(3, e, t - 1e-9)[0].element,
                      fit.facing.sources(3, e, t + 1e-9)[0].element);
      ++count;
    }
  // each node of the ring ends two of its elements
  TEST_EQUALITY(count, 2 * fit.multiplier.elements(0).size());
  TEST_EQUALITY(fit.facing.sourceBreaks(2, 0).size(), 0u);
}

/// A multiplier that acts where nothing lies opposite is refused: on a whole element, and on a part.
TEUCHOS_UNIT_TEST(Opposite, elementsOfContactAreCovered) {
  const bem::Loop wide{{{0, 1}, {4, 1}, {4, 2}, {0, 2}}, {"face", "s", "s", "s"}};
  const bem::Mesh side = makeMesh(
      std::make_shared<const bem::Outline>(wide, std::vector<bem::Loop>{}, tenth),
      {4, 1, 1, 1}, 1);
  for (const auto& [from, to, covered] :
       {std::tuple(-1.0, 5.0, true), std::tuple(0.0, 4.0, true),
        std::tuple(1e-6, 4.0, true), std::tuple(0.0, 3.0, false),
        std::tuple(0.5, 4.0, false)}) {
    for (const char* law : {"None", "Tied"}) {
      contact::Conditions conditions;
      contact::Conditions::Contact contact{{}, contact::makeFriction(law, {})};
      contact.name = "c";
      contact.parts = {{0, 0, 1}};
      conditions.contact["face"] = contact;
      const contact::MultiplierSpace multiplier(
          side, contact::multiplierBasis("Gauss-Legendre-Lagrange"), conditions);
      const bem::Outline plate(
          {{{from, 0}, {to, 0}, {to, 1}, {from, 1}}, {"s", "s", "s", "s"}}, {}, tenth);
      contact::OppositeSide opposite;
      opposite.rigid = 0;
      opposite.curves = CurveTree({plate.edge(2).curve});
      opposite.visibility = {side.outline().curves().curves(), plate.curves().curves(),
                             1e-10};
      const auto make = [&] {
        contact::Opposite(multiplier, tenth.length, {{"c", opposite}});
      };
      if (covered)
        make();
      else
        TEST_THROW(make(), bem::InputError);
    }
  }
}

}  // namespace

}  // namespace epafi
