// Nodes that follow a transition, and the layers that go along.
#include "adaptivity/refine/MovingNodes.hpp"

#include "Processes.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "bem/base/Error.hpp"
#include "bem/space/CauchyData.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

using adaptivity::Move;
using adaptivity::Transition;
using contact::MultiplierSpace;

namespace {

/// The unit square, two elements on its first edge.
bem::Mesh coarse() {
  const auto outline = std::make_shared<const bem::Outline>(reference::square());
  return bem::makeMesh(outline, {2, 1, 1, 1}, 1);
}

/// The fractions of the first edge's length at which nodes lie; the edge has length 1/√2
/// of the outline's diameter.
const std::vector<double> layers = {0.2, 0.29, 0.299, 0.3, 0.301, 0.31, 0.4, 0.5, 0.8};
const int middle = 4;  // node 4 is at 0.3

bem::Mesh layered() {
  return reference::cutMesh(coarse().sharedOutline(), {{0, layers}}, {3});
}

const double unit = 1 / std::sqrt(2.0);

Transition at(double fraction) { return {0, fraction * unit}; }

std::vector<Move> movesTo(const std::vector<double>& fractions, double reach) {
  std::vector<Transition> transitions;
  transitions.reserve(fractions.size());
  for (const double fraction : fractions)
    transitions.push_back(at(fraction));
  return adaptivity::chooseMoves(layered(), adaptivity::heldNodes(layered(), coarse()),
                                 transitions, reach);
}

bem::Mesh movedTo(double fraction) {
  return adaptivity::moveNodes(layered(), adaptivity::heldNodes(layered(), coarse()),
                               movesTo({fraction}, 1));
}

}  // namespace

TEUCHOS_UNIT_TEST(MovingNodes, nodesOfTheScenesOwnMeshAreHeld) {
  const std::vector<bool> held = adaptivity::heldNodes(layered(), coarse());
  std::vector<int> nodes;
  for (std::size_t k = 0; k < held.size(); ++k)
    if (held[k])
      nodes.push_back(static_cast<int>(k));
  TEST_ASSERT((nodes == std::vector<int>{0, 8, 10, 11, 12}));
}

TEUCHOS_UNIT_TEST(MovingNodes, theMiddleOfTheLayersGoesToTheTransition) {
  for (const double place : {0.2995, 0.3004, 0.307, 0.292}) {
    const std::vector<Move> moves = movesTo({place}, 1);
    TEST_EQUALITY(moves.size(), std::size_t(1));
    TEST_EQUALITY(moves.front().node, middle);
    TEST_FLOATING_EQUALITY(moves.front().to.fromStart, place * unit, 1e-14);
    TEST_FLOATING_EQUALITY(moves.front().to.toEnd, (1 - place) * unit, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(MovingNodes, stayWhereTheTransitionIsOutOfReachOrAlreadyThere) {
  TEST_ASSERT(movesTo({0.38}, 0.1).empty());
  TEST_ASSERT(movesTo({0.31 + 1e-3}, 0).empty());
  TEST_ASSERT(movesTo({0.3 + 1e-6}, 1).empty());
  TEST_ASSERT(movesTo({0.48, 0.52}, 0.01).empty());  // 0.5 is the scene's
}

TEUCHOS_UNIT_TEST(MovingNodes, doNotOvertakeEachOther) {
  const std::vector<bool> held = adaptivity::heldNodes(layered(), coarse());
  for (const auto& places :
       {std::vector<double>{0.307, 0.308}, {0.308, 0.307}, {0.2995, 0.3005, 0.305}}) {
    const bem::Mesh moved = adaptivity::moveNodes(layered(), held, movesTo(places, 1));
    for (int e = 0; e < moved.size(); ++e) {
      const double factor = moved[e].half / layered()[e].half;
      TEST_COMPARE(factor, >, 0.25);
      TEST_COMPARE(factor, <, 4);
    }
  }
}

TEUCHOS_UNIT_TEST(MovingNodes, layersGoAlongAndStayGeometric) {
  const bem::Mesh mesh = layered();
  const bem::Mesh moved = movedTo(0.293);
  TEST_FLOATING_EQUALITY(moved[middle].piece.start.fromStart, 0.293 * unit, 1e-14);
  for (int e = 0; e < mesh.size(); ++e) {
    const double factor = e < middle ? 0.293 / 0.3 : e < 8 ? 0.207 / 0.2 : 1;
    TEST_FLOATING_EQUALITY(moved[e].half, factor * mesh[e].half, 1e-12);
    TEST_EQUALITY(moved[e].degree, mesh[e].degree);
  }
}

TEUCHOS_UNIT_TEST(MovingNodes, digitsNextToVerticesSurvive) {
  const auto outline = coarse().sharedOutline();
  const bem::Mesh mesh = reference::cutMesh(outline, {{0, {1e-12, 1e-6, 0.4}}}, {2});
  const bem::Mesh moved = adaptivity::moveNodes(
      mesh, adaptivity::heldNodes(mesh, coarse()), {{3, {0.3 * unit, 0.7 * unit}}});
  TEST_FLOATING_EQUALITY(moved[0].half, 0.75 * mesh[0].half, 1e-14);
  TEST_FLOATING_EQUALITY(moved[1].half, 0.75 * mesh[1].half, 1e-14);
}

TEUCHOS_UNIT_TEST(MovingNodes, allRanksTakeThoseOfTheFirst) {
  const std::vector<Move> moves = movesTo({0.307}, 1);
  const std::vector<Move> agreed = adaptivity::agree(moves, test::processes());
  TEST_EQUALITY(agreed.size(), moves.size());
  TEST_EQUALITY(agreed.front().node, moves.front().node);
  TEST_EQUALITY(agreed.front().to.fromStart, moves.front().to.fromStart);
  TEST_EQUALITY(agreed.front().to.toEnd, moves.front().to.toEnd);
  TEST_ASSERT(adaptivity::agree({}, test::processes()).empty());
}

TEUCHOS_UNIT_TEST(MovingNodes, leaveAMultiplierThatIsOnePolynomialUnchanged) {
  contact::Conditions conditions;
  conditions.contact["side"] = {
      {}, contact::makeFriction("Tresca", {[](bem::Vec2) { return 1.0; }})};
  const bem::Mesh from = layered();
  const bem::Mesh to = movedTo(0.307);
  const auto cubic = [](double s) { return 1 - 2 * s + 3 * s * s - 5 * s * s * s; };
  for (const contact::MultiplierBasis& basis : contact::multiplierBases()) {
    const std::string name = basis.name;
    if (name.find("Lagrange") == std::string::npos)
      continue;  // the others' coefficients are no values
    const auto values = [&](const bem::Mesh& mesh) {
      const MultiplierSpace space(mesh, basis, conditions);
      bem::Vector normal;
      bem::Vector tangential;
      for (const auto& element : space.elements())
        for (const double t : basis.places(element.degree)) {
          const bem::Element& e = mesh[element.element];
          const double s = e.piece.start.fromStart + e.half * (1 + t);
          normal.push_back(cubic(s));
          tangential.push_back(-2 * cubic(s));
        }
      normal.insert(normal.end(), tangential.begin(), tangential.end());
      return normal;
    };
    const bem::Vector carried = adaptivity::carryMultiplier(
        from, MultiplierSpace(from, basis, conditions), values(from), to,
        MultiplierSpace(to, basis, conditions));
    const bem::Vector expected = values(to);
    TEST_EQUALITY(carried.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      TEST_COMPARE(std::abs(carried[k] - expected[k]), <, 1e-11);
  }
}

TEUCHOS_UNIT_TEST(MovingNodes, nothingIsCarriedToWhereNoContactWas) {
  const bem::Loop loop{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                       {"bottom", "right", "top", "left"}};
  const bem::Mesh mesh =
      bem::makeMesh(std::make_shared<bem::Outline>(loop), {2, 2, 2, 2}, 1);
  const contact::MultiplierBasis& basis =
      contact::multiplierBasis("Gauss-Legendre-Lagrange");
  contact::Conditions one;
  one.contact["bottom"] = {};
  contact::Conditions two = one;
  two.contact["right"] = {};
  const MultiplierSpace oneSide(mesh, basis, one);
  const MultiplierSpace twoSides(mesh, basis, two);
  contact::Conditions other;
  other.contact["right"] = {};
  const MultiplierSpace otherSide(mesh, basis, other);
  const auto carry = [&](const MultiplierSpace& from, const MultiplierSpace& to) {
    const bem::Vector ones(from.size(), 1.0);
    return adaptivity::carryMultiplier(mesh, from, ones, mesh, to);
  };
  TEST_THROW(carry(oneSide, twoSides), bem::NumericalError);
  TEST_THROW(carry(oneSide, otherSide), bem::NumericalError);
  TEST_EQUALITY(carry(oneSide, oneSide).size(), static_cast<std::size_t>(oneSide.size()));
}

// Errors against a reference with other nodes rest on this.
TEUCHOS_UNIT_TEST(MovingNodes, aUnionHoldsTheNodesOfBothMeshes) {
  const bem::Mesh a = layered();
  const bem::Mesh b = movedTo(0.293);
  const bem::UnionMesh both = bem::unite(a, b);
  // 8 nodes left of 1/2 moved, the others are common
  TEST_EQUALITY(both.mesh.size(), a.size() + 7);
  for (int e = 0; e < both.mesh.size(); ++e) {
    for (const double t : {-1.0, 0.3, 1.0}) {
      const bem::Vec2 place = both.mesh.scaledPoint(e, t);
      const bem::Origin& inA = both.first[e];
      const bem::Origin& inB = both.second[e];
      const double ta = inA.middle + inA.scale * t;
      const double tb = inB.middle + inB.scale * t;
      TEST_COMPARE(norm(place - a.scaledPoint(inA.element, ta)), <, 1e-14);
      TEST_COMPARE(norm(place - b.scaledPoint(inB.element, tb)), <, 1e-14);
      TEST_COMPARE(std::max(std::abs(ta), std::abs(tb)), <, 1 + 1e-9);
    }
  }
}

}  // namespace epafi
