// The numbering of multipliers that belong to the displacement's nodes.
#include "contact/multiplier/MultiplierSpace.hpp"

#include "bem/base/Error.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <set>

namespace {

using namespace epafi;
using contact::Conditions;
using contact::Index;
using contact::MultiplierSpace;

/// The unit square, three elements on every side.
bem::Mesh squareMesh(int degree) {
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"bottom", "right", "top", "left"}};
  return bem::makeMesh(std::make_shared<bem::Outline>(square), {3, 3, 3, 3}, degree);
}

double zero(bem::Vec2) { return 0; }

Conditions::Contact frictional() {
  return {{}, &contact::frictionLaw("Tresca"), [](bem::Vec2) { return 1.0; }};
}

const contact::MultiplierBasis& dual() {
  return contact::multiplierBasis("Biorthogonal");
}

/// Normal and tangential coefficients.
struct Counts {
  Index normal;
  Index tangential;
};

Counts countsOf(const Conditions& conditions, int degree) {
  const MultiplierSpace space(squareMesh(degree), dual(), conditions);
  std::set<Index> used;
  for (const auto& element : space.elements())
    for (int i = 0; i <= element.degree; ++i) {
      used.insert(element.normalOf(i));
      if (element.tangential >= 0)
        used.insert(element.tangentialOf(i));
    }
  const Index all = space.size();  // numbered without gaps
  const bool whole = static_cast<Index>(used.size()) == all && *used.begin() == 0 &&
                     *used.rbegin() == all - 1;
  return whole ? Counts{space.normals(), all - space.normals()} : Counts{-1, -1};
}

TEUCHOS_UNIT_TEST(MultiplierSpace, sharedNodesHaveOneCoefficientInEachDirection) {
  for (int p : {1, 2, 5}) {
    Conditions conditions;
    conditions.contact["bottom"] = frictional();
    const Counts counts = countsOf(conditions, p);
    TEST_EQUALITY(counts.normal, 3 * p + 1);
    TEST_EQUALITY(counts.tangential, 3 * p + 1);
  }
}

TEUCHOS_UNIT_TEST(MultiplierSpace, clampsTakeTheComponentsThatTheyPrescribe) {
  for (int p : {1, 2, 5}) {
    Conditions conditions;
    conditions.contact["bottom"] = frictional();
    conditions.dirichlet["left"] = {zero, zero};
    conditions.dirichlet["right"] = {zero, {}};  // stops sliding, not lifting
    const Counts counts = countsOf(conditions, p);
    TEST_EQUALITY(counts.normal, 3 * p);
    TEST_EQUALITY(counts.tangential, 3 * p - 1);
  }
}

TEUCHOS_UNIT_TEST(MultiplierSpace, atACornerNormalsComeFirst) {
  for (int p : {1, 4}) {
    Conditions conditions;
    conditions.contact["bottom"] = frictional();
    conditions.contact["right"] = frictional();
    const Counts counts = countsOf(conditions, p);
    TEST_EQUALITY(counts.normal, 2 * (3 * p + 1));
    TEST_EQUALITY(counts.tangential, 2 * 3 * p);
  }
}

TEUCHOS_UNIT_TEST(MultiplierSpace, withSharedNodesStillHoldsConstants) {
  Conditions conditions;
  conditions.contact["bottom"] = frictional();
  conditions.dirichlet["left"] = {zero, zero};
  for (int p : {1, 2, 5}) {
    const MultiplierSpace space(squareMesh(p), dual(), conditions);
    bem::Vector ones(static_cast<std::size_t>(space.size()), 1.0);
    for (const auto& element : space.elements())
      for (double t : {-1.0, -0.3, 0.8}) {
        TEST_COMPARE(std::abs(space.at(ones, element, t).normal - 1), <, 1e-13);
        TEST_COMPARE(std::abs(space.at(ones, element, t).tangential - 1), <, 1e-13);
      }
  }
}

TEUCHOS_UNIT_TEST(MultiplierSpace, anElementWithoutFreeNodesIsRefused) {
  Conditions conditions;
  conditions.contact["bottom"] = frictional();
  conditions.dirichlet["left"] = {zero, zero};
  conditions.dirichlet["right"] = {zero, zero};
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"bottom", "right", "top", "left"}};
  const auto outline = std::make_shared<bem::Outline>(square);
  TEST_THROW(MultiplierSpace(bem::makeMesh(outline, {1, 1, 1, 1}, 1), dual(), conditions),
             bem::InputError);
  TEST_NOTHROW(
      MultiplierSpace(bem::makeMesh(outline, {2, 1, 1, 1}, 1), dual(), conditions));
}

}  // namespace
