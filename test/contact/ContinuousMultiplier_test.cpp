// The multiplier that does the same work and does not jump at nodes.
#include "contact/multiplier/ContinuousMultiplier.hpp"

#include "Rectangle.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi {

namespace {

using contact::MultiplierSpace;
using Value = MultiplierSpace::Value;

/// Unequal elements at the bottom of the unit square.
bem::Mesh unequalMesh() {
  const auto outline = test::outlineOf(test::rectangle({0, 0}, 1, 1));
  const double whole = outline->edges()[0].curve.length();
  std::vector<bem::Piece> pieces;
  const double places[] = {0, 0.05, 0.1, 0.45, 0.7, 0.9, 1};
  const int degrees[] = {2, 1, 3, 2, 2, 1};
  for (int k = 0; k < 6; ++k) {
    const auto at = [&](double part) {
      return bem::Position{part * whole, (1 - part) * whole};
    };
    pieces.push_back({0, at(places[k]), at(places[k + 1]), degrees[k]});
  }
  for (int edge = 1; edge < 4; ++edge)
    pieces.push_back({edge, {0, whole}, {whole, 0}, 2});
  return {outline, pieces};
}

contact::Conditions frictional() {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      {}, contact::makeFriction("Tresca", {[](bem::Vec2) { return 1.0; }})};
  return conditions;
}

double any(int k) { return std::sin(12.9898 * k + 0.5); }

/// A disc of two half circles, all of it one side.
bem::Mesh discMesh() {
  bem::Loop loop{{{1, 0}, {-1, 0}}, {"bottom", "bottom"}};
  loop.bulges = {1, 1};
  return bem::makeMesh(test::outlineOf(loop), {3, 2}, 2);
}

struct Sample {
  bem::Mesh mesh;
  contact::Conditions conditions = frictional();
  MultiplierSpace space{mesh, contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                        conditions};
  bem::Vector multiplier;
  bem::Vector bounds = bem::Vector(static_cast<std::size_t>(space.size()), 1e9);

  explicit Sample(bem::Mesh of = unequalMesh()) : mesh(std::move(of)) {
    for (bem::Index i = 0; i < space.size(); ++i)
      multiplier.push_back(any(static_cast<int>(i)));
  }

  bem::Vector continuous() const {
    return contact::withoutJumps(space, 0, multiplier, bounds);
  }
  /// At the node in front of contact element k > 0.
  Value jump(const bem::Vector& of, std::size_t k) const {
    const Value before = space.at(of, space.elements(0)[k - 1], 1);
    const Value behind = space.at(of, space.elements(0)[k], -1);
    return {behind.normal - before.normal, behind.tangential - before.tangential};
  }
};

}  // namespace

TEUCHOS_UNIT_TEST(ContinuousMultiplier, doesNotJumpAtNodes) {
  const Sample sample;
  const bem::Vector continuous = sample.continuous();
  for (std::size_t k = 2; k < 5; ++k) {
    TEST_COMPARE(std::abs(sample.jump(sample.multiplier, k).normal), >, 1e-2);
    TEST_COMPARE(std::abs(sample.jump(continuous, k).normal), <, 1e-13);
    TEST_COMPARE(std::abs(sample.jump(continuous, k).tangential), <, 1e-13);
  }
}

TEUCHOS_UNIT_TEST(ContinuousMultiplier, doesNotJumpWhereArcsMeetSmoothly) {
  const Sample sample(discMesh());
  const bem::Vector continuous = sample.continuous();
  for (std::size_t k = 1; k < sample.space.elements(0).size(); ++k) {
    TEST_COMPARE(std::abs(sample.jump(sample.multiplier, k).normal), >, 1e-3);
    TEST_COMPARE(std::abs(sample.jump(continuous, k).normal), <, 1e-13);
  }
}

// Where stresses may be singular.
TEUCHOS_UNIT_TEST(ContinuousMultiplier, isTheMultiplierItselfAtEndsOfASide) {
  const Sample sample;
  const bem::Vector continuous = sample.continuous();
  for (const auto* element :
       {&sample.space.elements(0).front(), &sample.space.elements(0).back()})
    for (int i = 0; i <= element->degree; ++i)
      TEST_EQUALITY(continuous[element->normalOf(i)],
                    sample.multiplier[element->normalOf(i)]);
}

TEUCHOS_UNIT_TEST(ContinuousMultiplier, doesTheSameWorkOnEveryDisplacement) {
  const Sample sample;
  bem::Vector change = sample.continuous();
  for (std::size_t i = 0; i < change.size(); ++i)
    change[i] -= sample.multiplier[i];
  TEST_COMPARE(*std::max_element(change.begin(), change.end()), >, 1e-2);
  const bem::Space space(sample.mesh);
  const bem::Rule& rule = bem::gaussLegendre(5);
  for (int trial = 0; trial < 10; ++trial) {
    bem::Vector v;
    for (bem::Index i = 0; i < space.displacements(); ++i)
      v.push_back(any(static_cast<int>(i) + 100 * trial));
    double work = 0;
    for (const auto& element : sample.space.elements(0))
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const double t = rule.points[q];
        const bem::Element& geometry = sample.mesh[element.element];
        const Value value = sample.space.at(change, element, t);
        const bem::Vec2 traction = value.normal * geometry.curve.normal(t) +
                                   value.tangential * geometry.curve.tangent(t);
        work += geometry.half * rule.weights[q] *
                dot(traction, bem::DisplacementField(space, v).at(element.element, t));
      }
    TEST_COMPARE(std::abs(work), <, 1e-13);
  }
}

TEUCHOS_UNIT_TEST(ContinuousMultiplier, ofOneThatDoesNotJumpIsItself) {
  Sample sample;
  std::fill(sample.multiplier.begin(), sample.multiplier.end(), 0.7);
  const bem::Vector continuous = sample.continuous();
  for (const double coefficient : continuous)
    TEST_FLOATING_EQUALITY(coefficient, 0.7, 1e-13);
}

// Open, and where slip turns round: true jumps stay.
TEUCHOS_UNIT_TEST(ContinuousMultiplier,
                  leavesJumpsBesideNoStressAndBetweenDirectionsOfSlip) {
  Sample sample;
  const auto& elements = sample.space.elements(0);
  for (int i = 0; i <= elements[4].degree; ++i) {
    sample.multiplier[elements[4].normalOf(i)] = 0;
    sample.multiplier[elements[4].tangentialOf(i)] = 0;
  }
  for (int i = 0; i <= elements[1].degree; ++i) {
    sample.multiplier[elements[1].tangentialOf(i)] = -1;
    sample.bounds[elements[1].tangentialOf(i)] = 1;
  }
  for (int i = 0; i <= elements[2].degree; ++i) {
    sample.multiplier[elements[2].tangentialOf(i)] = 1;
    sample.bounds[elements[2].tangentialOf(i)] = 1;
  }
  const bem::Vector continuous = sample.continuous();
  for (int i = 0; i <= elements[4].degree; ++i)
    TEST_EQUALITY(continuous[elements[4].normalOf(i)], 0.0);
  for (int i = 0; i <= elements[1].degree; ++i)
    TEST_EQUALITY(continuous[elements[1].tangentialOf(i)], -1.0);
  TEST_COMPARE(std::abs(sample.jump(continuous, 2).normal), <, 1e-13);
}

}  // namespace epafi
