// Where contact ends, told from a displacement that opens like d^(3/2).
#include "adaptivity/singular/Transitions.hpp"

#include "SquareMesh.hpp"
#include "adaptivity/singular/Extrapolation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

using adaptivity::LocatedTransitions;
using adaptivity::Samples;
using adaptivity::Singularity;
using contact::FrictionState;
using contact::MultiplierSpace;
using contact::NormalState;

namespace {

/// 3/2 powers of the distance from a, where x lies behind it.
double growth(double x, double a) { return x > a ? std::pow(x - a, 1.5) : 0.0; }

contact::Conditions contactAtBottom(const char* law) {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      {}, contact::makeFriction(law, {[](bem::Vec2) { return 0.3; }})};
  return conditions;
}

/// Contact ends at a, stick at b < a, on a side of contact from 0 to 1; everything is
/// measured in the scaled outline.
struct Opening {
  double a;
  double b;

  bem::Vec2 displacement(bem::Vec2 x, const bem::Mesh& mesh) const {
    const double s = x.x - mesh.scaledPoint(0, -1).x;
    return {growth(s, b) * (1 + 0.2 * s), growth(s, a) * (1 + 0.3 * s)};
  }
  contact::ContactState states(const bem::Mesh& mesh,
                               const MultiplierSpace& multiplier) const {
    contact::ContactState states;
    for (const auto& element : multiplier.elements())
      for (const double t : multiplier.basis().places(element.degree)) {
        const double s = mesh[element.element].piece.start.fromStart +
                         mesh[element.element].half * (1 + t);
        states.normal.push_back(s < a ? NormalState::Closed : NormalState::Open);
        states.tangential.push_back(s < b ? FrictionState::Stick
                                          : FrictionState::SlipForward);
      }
    return states;
  }
};

LocatedTransitions locate(const bem::Mesh& mesh, const char* law, const Opening& opening,
                          const contact::ContactState* other = nullptr) {
  const bem::Space space(mesh);
  const contact::Conditions conditions = contactAtBottom(law);
  const MultiplierSpace multiplier(
      mesh, contact::multiplierBasis("Gauss-Legendre-Lagrange"), conditions);
  const bem::Vector u =
      space.interpolate([&](bem::Vec2 x) { return opening.displacement(x, mesh); });
  const contact::ContactState states =
      other != nullptr ? *other : opening.states(mesh, multiplier);
  return adaptivity::locateTransitions(
      space, conditions, multiplier,
      contact::DistantObstacle(mesh, mesh.outline().scaling().length), {states, u});
}

Samples sampled(double a, double slope) {
  Samples samples;
  for (int k = 0; k < 12; ++k) {
    const double x = 0.1 * k;
    samples.places.push_back(x);
    samples.values.push_back(growth(x, a) * std::pow(1 + slope * (x - a), 1.5));
  }
  return samples;
}

}  // namespace

TEUCHOS_UNIT_TEST(Extrapolation, meetsTheBeginOfAThreeHalvesPowerExactly) {
  for (const double a : {-0.4, 0.0, 0.337})
    for (const double slope : {-0.2, 0.0, 0.5}) {
      const auto zero = adaptivity::beginOfGrowth(sampled(a, slope), a + 0.05);
      TEST_ASSERT(zero.has_value());
      TEST_COMPARE(std::abs(*zero - a), <, 1e-12);
    }
}

TEUCHOS_UNIT_TEST(Extrapolation, saysNothingFromThreeSamplesOrWithoutAZero) {
  TEST_ASSERT(!adaptivity::beginOfGrowth({{1, 2, 3, 4}, {1, 2, 3, -1}}, 0));
  TEST_ASSERT(!adaptivity::beginOfGrowth({{1, 2, 3, 4, 5}, {9, 3, 1, 3, 9}}, 3));
}

TEUCHOS_UNIT_TEST(Transitions, areLocatedToAFractionOfTheElementTheyAreIn) {
  const Opening opening{0.41, 0.17};
  const LocatedTransitions located = locate(test::squareMesh(8), "Tresca", opening);
  TEST_EQUALITY(located.transitions.size(), std::size_t(2));
  for (std::size_t k = 0; k < 2; ++k) {
    TEST_EQUALITY(located.transitions[k].edge, 0);
    TEST_COMPARE(std::abs(located.transitions[k].place - (k == 0 ? 0.41 : 0.17)), <,
                 2e-4);
  }
  for (const auto& inside : located.others.inside)
    TEST_ASSERT(inside.empty());
}

TEUCHOS_UNIT_TEST(Transitions, ofAFlickeringStateAreStillOne) {
  const Opening opening{0.41, 0.17};
  const bem::Mesh mesh = test::squareMesh(8);
  const MultiplierSpace multiplier(mesh,
                                   contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                   contactAtBottom("Tresca"));
  contact::ContactState states = opening.states(mesh, multiplier);
  std::size_t open = 0;
  while (states.normal[open] == NormalState::Closed)
    ++open;
  std::swap(states.normal[open], states.normal[open - 1]);
  const auto located = locate(mesh, "Tresca", opening, &states);
  TEST_EQUALITY(located.transitions.size(), std::size_t(2));
  TEST_COMPARE(std::abs(located.transitions[0].place - 0.41), <, 2e-4);
}

// A zone that opens inside one element has two ends, which one parabola cannot find.
TEUCHOS_UNIT_TEST(Transitions, ofAShortZoneStayWhereTheStatesChange) {
  const bem::Mesh mesh = test::squareMesh(8);
  const MultiplierSpace multiplier(mesh,
                                   contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                   contactAtBottom("Coulomb"));
  contact::ContactState states = Opening{2, 2}.states(mesh, multiplier);
  states.normal[12] = NormalState::Open;
  const auto located = locate(mesh, "Coulomb", {2, 2}, &states);
  TEST_ASSERT(located.transitions.empty());
  TEST_EQUALITY(located.others.inside[1].size(), std::size_t(2));
}

// As where slip turns round: the mesh makes a zone of stick of it, whose size is its own.
TEUCHOS_UNIT_TEST(Transitions, ofAHeldZoneOnTwoElementsStayWhereTheStatesChange) {
  const bem::Mesh mesh =
      bem::makeMesh(test::squareMesh(1).sharedOutline(), {8, 1, 1, 1}, 3);
  const MultiplierSpace multiplier(mesh,
                                   contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                   contactAtBottom("Tresca"));
  const double h = 2 * mesh[0].half;
  for (const int elements : {2, 3}) {
    contact::ContactState states = Opening{2, 3.5 * h}.states(mesh, multiplier);
    const std::size_t first = elements == 2 ? 8 : 4;  // stick begins here
    for (std::size_t k = 0; k < first; ++k)
      states.tangential[k] = FrictionState::SlipBackward;
    const auto located = locate(mesh, "Tresca", {2, 3.5 * h}, &states);
    TEST_EQUALITY(located.transitions.size(), std::size_t(elements == 2 ? 0 : 1));
  }
}

TEUCHOS_UNIT_TEST(Transitions, betweenTwoDirectionsOfSlipAreNotExtrapolated) {
  const bem::Mesh mesh = test::squareMesh(3);
  const MultiplierSpace multiplier(mesh,
                                   contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                   contactAtBottom("Tresca"));
  contact::ContactState states = Opening{2, 0}.states(mesh, multiplier);
  for (std::size_t k = 4; k < states.tangential.size(); ++k)
    states.tangential[k] = FrictionState::SlipBackward;
  const auto located = locate(mesh, "Tresca", {2, 0}, &states);
  TEST_ASSERT(located.transitions.empty());
  TEST_ASSERT(located.others.nodes[1] == Singularity::Strong);
}

TEUCHOS_UNIT_TEST(Transitions, nextToANodeAreAtTheNode) {
  const bem::Mesh mesh = test::squareMesh(2);
  const double h = 2 * mesh[0].half;
  const auto placed = [&](double place) {
    LocatedTransitions located{{{0, place}}, {}};
    located.others.nodes.resize(mesh.size());
    located.others.inside.resize(mesh.size());
    return adaptivity::placeOn(mesh, located);
  };
  for (const double offset : {-0.009, 0.0, 0.009}) {
    const auto points = placed((1 + offset) * h);
    TEST_ASSERT(points.nodes[1] == Singularity::Strong);
    TEST_ASSERT(points.inside[0].empty() && points.inside[1].empty());
  }
  const auto points = placed(1.25 * h);
  TEST_ASSERT(points.nodes[1] == Singularity::None);
  TEST_FLOATING_EQUALITY(points.inside[1].front(), -0.5, 1e-12);
}

}  // namespace epafi
