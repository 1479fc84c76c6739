#include "adaptivity/estimate/EquivalentMultiplier.hpp"

#include "Processes.hpp"
#include "Rectangle.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

using adaptivity::AtEnds;
using adaptivity::ContactCost;
using adaptivity::Contributions;
using bem::Vec2;
using contact::Conditions;
using test::SolvedScene;

namespace {

constexpr double shearModulus = 0.4;

double any(int k) { return std::sin(1.7 + 3.1 * k + 0.2 * k * k); }

/// Contact below and to the right, so that they meet at a corner, a clamp above and, on
/// the left, a roller if there is to be one.
SolvedScene::Input scene(const std::string& multiplier, bool roller) {
  const auto constant = [](double value) { return [=](Vec2) { return value; }; };
  Conditions conditions;
  conditions.contact["bottom"] = {{}, contact::makeFriction("Coulomb", {constant(0.3)})};
  conditions.contact["right"] = {constant(0.001),
                                 contact::makeFriction("Tresca", {constant(0.002)})};
  conditions.dirichlet["top"] = {[](Vec2 x) { return 0.01 * x.x; },
                                 [](Vec2) { return -0.01; }};
  if (roller)
    conditions.dirichlet["left"] = {constant(0.005), {}};
  return {bem::makeMesh(test::outlineOf(test::rectangle({-0.5, -0.5}, 1, 1)),
                        {3, 2, 2, 2}, 2),
          {2, 0.3, false},
          conditions,
          multiplier,
          test::suited(multiplier)};
}

std::vector<ContactCost> costsOf(const contact::Solved& solved) {
  Contributions factors;
  factors.fill(1);
  std::vector<ContactCost> costs;
  int k = 0;
  for (const auto& element : solved.problem.elements()) {
    const double size = 1e-4;
    const AtEnds moments{{size * any(k), size * any(k + 1)},
                         {size * any(k + 2), size * any(k + 3)}};
    adaptivity::KnownPlaces places(element);
    costs.emplace_back(solved, element, moments, factors, shearModulus, places);
    k += 4;
  }
  return costs;
}

double sum(const std::vector<ContactCost>& costs, const std::vector<AtEnds>& factors) {
  double sum = 0;
  for (std::size_t k = 0; k < costs.size(); ++k)
    sum += costs[k](factors[k]);
  return sum;
}

}  // namespace

TEUCHOS_UNIT_TEST(EndValue, standsForTheValueAtTheEnd) {
  for (int degree : {1, 2, 5, 12}) {
    const bem::Rule& rule = bem::gaussLegendre(degree + 1);
    for (int power = 0; power <= degree; ++power) {
      double end = 0;
      double start = 0;
      for (std::size_t q = 0; q < rule.points.size(); ++q) {
        const double t = rule.points[q];
        const double v = rule.weights[q] * std::pow(t, power);
        end += v * bem::endValues(degree, t).end;
        start += v * bem::endValues(degree, t).start;
      }
      TEST_FLOATING_EQUALITY(end, 1.0, 1e-12);
      TEST_FLOATING_EQUALITY(start, power % 2 == 0 ? 1.0 : -1.0, 1e-12);
    }
  }
}

TEUCHOS_UNIT_TEST(EquivalentMultiplier, doesTheSameWorkOnEveryDisplacement) {
  for (const char* multiplier : {"Gauss-Legendre-Lagrange", "Biorthogonal"})
    for (const bool roller : {false, true}) {
      const SolvedScene solvedScene(scene(multiplier, roller));
      const contact::Solved solved = solvedScene.solved();
      const auto& elements = solved.problem.elements();
      const auto factors = adaptivity::equivalentMultiplier(
          solved.space.mesh(), solved.conditions, elements, costsOf(solved));
      const std::vector<char> isPrescribed =
          contact::prescribed(solved.space, solved.conditions);
      const bem::Rule& rule = bem::gaussLegendre(4);
      for (int trial = 0; trial < 10; ++trial) {
        bem::Vector v;
        for (std::size_t i = 0; i < solved.displacement.size(); ++i)
          v.push_back(isPrescribed[i] ? 0 : any(static_cast<int>(i) + 50 * trial));
        double work = 0;
        double size = 0;
        for (std::size_t k = 0; k < elements.size(); ++k) {
          const int e = elements[k].element;
          const bem::Element& element = solved.space.mesh()[e];
          for (std::size_t q = 0; q < rule.points.size(); ++q) {
            const double t = rule.points[q];
            const double here = element.half * rule.weights[q] *
                                dot(valueAt(factors[k], element, t),
                                    bem::DisplacementField(solved.space, v).at(e, t));
            work += here;
            size += std::abs(here);
          }
        }
        TEST_COMPARE(size, >, 1e-6);
        TEST_COMPARE(std::abs(work), <, 1e-12 * size);
      }
    }
}

TEUCHOS_UNIT_TEST(EquivalentMultiplier, allRanksTakeThatOfTheFirst) {
  const double rank = test::processes().rank();
  const std::vector<AtEnds> agreed =
      adaptivity::agree({{{rank + 1, 2}, {3, 4 - rank}}, {{5 + rank, 6}, {7, rank + 8}}},
                        test::processes());
  TEST_EQUALITY(agreed.size(), 2u);
  TEST_ASSERT(agreed[0].start == (Vec2{1, 2}) && agreed[0].end == (Vec2{3, 4}));
  TEST_ASSERT(agreed[1].start == (Vec2{5, 6}) && agreed[1].end == (Vec2{7, 8}));
  TEST_ASSERT(adaptivity::agree({}, test::processes()).empty());
}

TEUCHOS_UNIT_TEST(EquivalentMultiplier, costsLess) {
  const SolvedScene solvedScene(scene("Gauss-Legendre-Lagrange", true));
  const contact::Solved solved = solvedScene.solved();
  const auto& elements = solved.problem.elements();
  const std::vector<ContactCost> costs = costsOf(solved);
  const auto factors = adaptivity::equivalentMultiplier(
      solved.space.mesh(), solved.conditions, elements, costs);
  TEST_COMPARE(sum(costs, factors), <,
               sum(costs, std::vector<AtEnds>(elements.size())) - 1e-9);
}

// h/p (|r + w|² - |r|²), w = valueAt(c), for polynomials r of the element's degree.
TEUCHOS_UNIT_TEST(ContactCost, hasTheResidualsSquareExactly) {
  const SolvedScene solvedScene(scene("Gauss-Legendre-Lagrange", false));
  const contact::Solved solved = solvedScene.solved();
  Contributions factors{};
  factors[static_cast<std::size_t>(adaptivity::Source::Contact)] = 3;
  int trial = 0;
  for (const auto& contact : solved.problem.elements()) {
    const bem::Element& element = solved.space.mesh()[contact.element];
    const int k = 20 * ++trial;
    const auto r = [&](double t) {
      Vec2 sum;
      for (int i = 0; i <= contact.degree; ++i)
        sum = sum + std::pow(t, i) * Vec2{any(k + i), any(k + i + 5)};
      return sum;
    };
    const AtEnds c{{any(k + 10), any(k + 11)}, {any(k + 12), any(k + 13)}};
    const bem::Rule& rule = bem::gaussLegendre(contact.degree + 1);
    AtEnds moments;
    double change = 0;
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      const double t = rule.points[q];
      const double weight = rule.weights[q] * element.half;
      moments.start =
          moments.start + weight * bem::endValues(contact.degree, t).start * r(t);
      moments.end = moments.end + weight * bem::endValues(contact.degree, t).end * r(t);
      const Vec2 w = valueAt(c, element, t);
      change += weight * (dot(r(t) + w, r(t) + w) - dot(r(t), r(t)));
    }
    adaptivity::KnownPlaces places(contact);
    const ContactCost cost(solved, contact, moments, factors, shearModulus, places);
    const double size = 2 * element.half / contact.degree;
    TEST_FLOATING_EQUALITY(cost(c) - cost({}), 3 * size * change, 1e-12);
    // exact for quadratics: the derivative along c by a central difference
    const auto along = [&](double s) { return cost({s * c.start, s * c.end}); };
    const AtEnds slope = cost.slope({});
    TEST_FLOATING_EQUALITY(2 * (dot(slope.start, c.start) + dot(slope.end, c.end)),
                           0.5 * (along(1) - along(-1)), 1e-12);
  }
}

// As a function of the correction it is the squared estimate's share, up to a constant.
TEUCHOS_UNIT_TEST(ContactCost, differsFromTheTermsByAConstant) {
  const SolvedScene solvedScene(scene("Gauss-Legendre-Lagrange", false));
  const contact::Solved solved = solvedScene.solved();
  Contributions factors;
  factors.fill(1);
  factors[static_cast<std::size_t>(adaptivity::Source::Contact)] = 0;
  for (const auto& element : solved.problem.elements()) {
    adaptivity::KnownPlaces places(element);
    const ContactCost cost(solved, element, {}, factors, shearModulus, places);
    const auto terms = [&](const AtEnds& correction) {
      Contributions squares = sharpContactTerms(
          contactProfiles(solved, element, correction, places), shearModulus);
      double sum = -of(squares, adaptivity::Source::Penetration);
      for (const double square : squares)
        sum += square;
      return sum;
    };
    for (int trial = 0; trial < 5; ++trial) {
      const double size = 1e-4;
      const AtEnds correction{{size * any(trial), size * any(trial + 7)},
                              {size * any(trial + 11), size * any(trial + 17)}};
      // one rule across the kinks against a broken one
      TEST_FLOATING_EQUALITY(cost(correction), terms(correction), 0.1);
    }
  }
}

}  // namespace epafi
