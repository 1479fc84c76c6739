#include "adaptivity/refine/Refine.hpp"

#include "Rectangle.hpp"
#include "adaptivity/refine/StartValue.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace epafi {

using adaptivity::Mark;
using adaptivity::Marks;
using contact::MultiplierSpace;

namespace {

Marks only(const bem::Mesh& mesh, int element, const Mark& mark) {
  Marks marks(mesh.size(), Mark::None);
  marks[element] = mark;
  return marks;
}

/// Every kind of mark.
Marks inTurn(const bem::Mesh& mesh) {
  Marks marks(mesh.size(), Mark::None);
  for (std::size_t e = 0; e < marks.size(); ++e)
    marks[e] = static_cast<Mark::Kind>(e % 3);
  return marks;
}

/// The last element of the first edge: it ends at a vertex.
int lastOfFirstEdge(const bem::Mesh& mesh) {
  int e = 0;
  while (mesh[e + 1].piece.edge == 0)
    ++e;
  return e;
}

contact::Conditions contactAtBottomAndTop() {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      {}, contact::makeFriction("Coulomb", {[](bem::Vec2) { return 0.3; }})};
  conditions.contact["top"] = {};
  return conditions;
}

/// Some state with no symmetry at all.
contact::State anyState(const MultiplierSpace& space) {
  contact::State state;
  for (bem::Index i = 0; i < space.size(); ++i)
    state.multiplier.push_back(std::sin(1.0 + 2.7 * static_cast<double>(i)));
  state.rigid = {0.25, -3};
  return state;
}

struct Next {
  bem::Mesh mesh;
  contact::State start;
};

Next refined(const bem::Mesh& mesh, const Marks& marks, const MultiplierSpace& space,
             const contact::Conditions& conditions, const contact::State& state) {
  bem::Mesh next = adaptivity::refine(mesh, marks);
  contact::State start =
      adaptivity::carry(space, state, MultiplierSpace(next, space.basis(), conditions));
  return {std::move(next), std::move(start)};
}

struct Place {
  double normal;
  double tangential;
};

/// The multiplier at a scaled point, found by searching.
Place valueAt(const bem::Mesh& mesh, const MultiplierSpace& space,
              const bem::Vector& multiplier, bem::Vec2 x) {
  for (const auto& element : space.elements(0)) {
    const bem::Element& e = mesh[element.element];
    const bem::Vec2 arm = x - e.segment().middle;
    const double t = dot(arm, e.segment().tangent) / e.half;
    if (std::abs(dot(arm, e.segment().normal)) < 1e-12 && std::abs(t) <= 1) {
      const auto value = space.at(multiplier, element, t);
      return {value.normal, value.tangential};
    }
  }
  return {NAN, NAN};
}

}  // namespace

TEUCHOS_UNIT_TEST(Refine, bisectionKeepsAllDigitsNextToBothVertices) {
  bem::Mesh mesh = test::squareMesh(1);
  const double first = mesh[0].half;
  const double last = mesh[lastOfFirstEdge(mesh)].half;
  for (int k = 1; k <= 60; ++k) {
    mesh = adaptivity::refine(mesh, only(mesh, 0, Mark::Bisect));
    mesh = adaptivity::refine(mesh, only(mesh, lastOfFirstEdge(mesh), Mark::Bisect));
    TEST_FLOATING_EQUALITY(mesh[0].half, std::ldexp(first, -k), 1e-15);
    TEST_FLOATING_EQUALITY(mesh[lastOfFirstEdge(mesh)].half, std::ldexp(last, -k), 1e-15);
  }
}

TEUCHOS_UNIT_TEST(Refine, theBoundaryKeepsItsLengthAndItsNames) {
  bem::Mesh mesh = test::squareMesh(2);
  const auto length = [](const bem::Mesh& m, const std::string& boundary) {
    double sum = 0;
    for (const int e : m.elementsOf(boundary))
      sum += 2 * m[e].half;
    return sum;
  };
  const bem::Mesh next = adaptivity::refine(mesh, inTurn(mesh));
  for (const char* boundary : {"bottom", "right", "top", "left"})
    TEST_FLOATING_EQUALITY(length(next, boundary), length(mesh, boundary), 1e-14);
}

TEUCHOS_UNIT_TEST(Refine, theMultiplierStaysTheSameFunctionInEveryDiscontinuousBasis) {
  const contact::Conditions conditions = contactAtBottomAndTop();
  for (const contact::MultiplierBasis& basis : contact::multiplierBases())
    for (const int degree : {1, 2, 5, 9}) {
      if (basis.sharesNodes)
        continue;
      const bem::Mesh mesh = test::squareMesh(degree);
      const MultiplierSpace space(mesh, basis, conditions);
      const contact::State state = anyState(space);
      const Next next = refined(mesh, inTurn(mesh), space, conditions, state);
      const MultiplierSpace finer(next.mesh, basis, conditions);
      TEST_EQUALITY(static_cast<bem::Index>(next.start.multiplier.size()), finer.size());
      TEST_COMPARE_ARRAYS(next.start.rigid, state.rigid);
      for (const auto& element : finer.elements(0))
        for (const double t : {-0.83, -0.2, 0.61}) {
          const auto value = finer.at(next.start.multiplier, element, t);
          const Place old = valueAt(mesh, space, state.multiplier,
                                    next.mesh.scaledPoint(element.element, t));
          TEST_COMPARE(std::abs(value.normal - old.normal), <, 1e-11);
          TEST_COMPARE(std::abs(value.tangential - old.tangential), <, 1e-11);
        }
    }
}

TEUCHOS_UNIT_TEST(Refine, constantsSurviveWhereNodesAreShared) {
  const contact::Conditions conditions = contactAtBottomAndTop();
  const contact::MultiplierBasis& basis = contact::multiplierBasis("Biorthogonal");
  const bem::Mesh mesh = test::squareMesh(3);
  const MultiplierSpace space(mesh, basis, conditions);
  contact::State state;
  state.multiplier.assign(space.size(), 0.7);
  const Next next = refined(mesh, inTurn(mesh), space, conditions, state);
  TEST_EQUALITY(static_cast<bem::Index>(next.start.multiplier.size()),
                MultiplierSpace(next.mesh, basis, conditions).size());
  for (const double coefficient : next.start.multiplier)
    TEST_FLOATING_EQUALITY(coefficient, 0.7, 1e-12);
}

TEUCHOS_UNIT_TEST(Refine, anEmptyStateStaysEmpty) {
  const contact::Conditions conditions = contactAtBottomAndTop();
  const bem::Mesh mesh = test::squareMesh(1);
  const MultiplierSpace space(mesh, contact::multiplierBases().front(), conditions);
  const Next next = refined(mesh, only(mesh, 0, Mark::RaiseDegree), space, conditions,
                            contact::State{});
  TEST_ASSERT(next.start.multiplier.empty());
  TEST_EQUALITY(next.mesh[0].degree, 2);
}

TEUCHOS_UNIT_TEST(Refine, degreesAboveTheLargestAreRefused) {
  const bem::Mesh mesh = test::squareMesh(bem::largestDegree);
  TEST_THROW(adaptivity::refine(mesh, only(mesh, 0, Mark::RaiseDegree)), bem::InputError);
}

namespace {

/// The unit square with nodes on its first edge, geometrically layered around a fraction of it.
bem::Mesh layeredAt(double middle) {
  const auto outline = std::make_shared<const bem::Outline>(reference::square());
  std::vector<double> nodes = {0.2, 0.4, 0.5, 0.8};
  for (const double layer : {-1e-2, -1e-3, 0.0, 1e-3, 1e-2})
    nodes.push_back(middle + layer);
  std::sort(nodes.begin(), nodes.end());
  return reference::cutMesh(outline, {{0, nodes}}, {3});
}

}  // namespace

TEUCHOS_UNIT_TEST(OtherNodes, leaveAMultiplierThatIsOnePolynomialUnchanged) {
  contact::Conditions conditions;
  conditions.contact["side"] = {
      {}, contact::makeFriction("Tresca", {[](bem::Vec2) { return 1.0; }})};
  const bem::Mesh from = layeredAt(0.3);
  const bem::Mesh to = layeredAt(0.307);
  const auto cubic = [](double s) { return 1 - 2 * s + 3 * s * s - 5 * s * s * s; };
  for (const contact::MultiplierBasis& basis : contact::multiplierBases()) {
    const std::string name = basis.name;
    if (name.find("Lagrange") == std::string::npos)
      continue;  // the others' coefficients are no values
    const auto values = [&](const bem::Mesh& mesh) {
      const MultiplierSpace space(mesh, basis, conditions);
      bem::Vector normal;
      bem::Vector tangential;
      for (const auto& element : space.elements(0))
        for (const double t : basis.places(element.degree)) {
          const bem::Element& e = mesh[element.element];
          const double s = e.piece.start.fromStart + e.half * (1 + t);
          normal.push_back(cubic(s));
          tangential.push_back(-2 * cubic(s));
        }
      normal.insert(normal.end(), tangential.begin(), tangential.end());
      return normal;
    };
    const bem::Vector carried =
        adaptivity::carryMultiplier(MultiplierSpace(from, basis, conditions),
                                    values(from), MultiplierSpace(to, basis, conditions));
    const bem::Vector expected = values(to);
    TEST_EQUALITY(carried.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      TEST_COMPARE(std::abs(carried[k] - expected[k]), <, 1e-11);
  }
}

TEUCHOS_UNIT_TEST(OtherNodes, nothingIsCarriedToWhereNoContactWas) {
  const bem::Mesh mesh = test::squareMesh({2, 2, 2, 2}, 1);
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
    return adaptivity::carryMultiplier(from, ones, to);
  };
  TEST_THROW(carry(oneSide, twoSides), bem::NumericalError);
  TEST_THROW(carry(oneSide, otherSide), bem::NumericalError);
  TEST_EQUALITY(carry(oneSide, oneSide).size(), static_cast<std::size_t>(oneSide.size()));
}

}  // namespace epafi
