#include "adaptivity/estimate/ResidualEstimator.hpp"

#include "Processes.hpp"
#include "Rectangle.hpp"
#include "adaptivity/estimate/Weights.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"
#include "reference/ExactFields.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <memory>
#include <numeric>

namespace epafi {

using adaptivity::Contributions;
using adaptivity::Indicators;
using adaptivity::Source;
using bem::Vec2;
using contact::Conditions;
using test::SolvedScene;

namespace {

const bem::Material material{2, 0.3, false};

/// [-1/2, 1/2]²
bem::Mesh squareMesh(int elements, int degree) {
  return bem::makeMesh(test::outlineOf(test::rectangle({-0.5, -0.5}, 1, 1)),
                       {elements, elements + 1, elements, elements}, degree);
}

Indicators estimate(const SolvedScene& scene, const std::string& weights = "Energy",
                    double residualFactor = 1) {
  const auto solved = scene.solved();
  return adaptivity::estimateResiduals({{solved, scene.density()}}, scene.lame(),
                                       {weights, residualFactor}, test::processes())
      .front();
}

bem::Function component(const std::function<Vec2(Vec2)>& f, double Vec2::*part) {
  return [=](Vec2 x) { return f(x).*part; };
}

/// Pressure 0.01 and Coulomb's shear at its bound, sliding to the right: constant stress,
/// linear displacement, u_y = 0 at the bottom.
struct Sliding {
  static constexpr double pressure = 0.01;
  double coefficient = 0.3;
  reference::PlaneStressTensor stress{0, -pressure, coefficient* pressure};

  Vec2 displacement(Vec2 x) const {
    const double mu = material.youngsModulus / (2 * (1 + material.poissonsRatio));
    const double trace = material.poissonsRatio * (stress.xx + stress.yy);
    const double xx = (stress.xx - trace) / (2 * mu);
    const double yy = (stress.yy - trace) / (2 * mu);
    const double xy = stress.xy / (2 * mu);
    return {xx * x.x + 2 * xy * (x.y + 0.5) + 0.1, yy * (x.y + 0.5)};
  }

  Conditions conditions() const {
    const auto exact = [self = *this](Vec2 x) { return self.displacement(x); };
    const auto constant = [](double value) { return [=](Vec2) { return value; }; };
    Conditions conditions;
    conditions.contact["bottom"] = {
        {}, contact::makeFriction("Coulomb", {constant(coefficient)})};
    conditions.dirichlet["top"] = {component(exact, &Vec2::x),
                                   component(exact, &Vec2::y)};
    conditions.neumann["right"] = {{}, constant(stress.xy)};
    if (coefficient == 0)  // a roller
      conditions.dirichlet["left"] = {component(exact, &Vec2::x), {}};
    else
      conditions.neumann["left"] = {{}, constant(-stress.xy)};
    return conditions;
  }
};

/// [P] 8.1.
SolvedScene::Input trescaScene(int elements, int degree) {
  Conditions conditions;
  conditions.contact["bottom"] = {
      [](Vec2 x) { return 1 - std::sqrt(1 - x.x * x.x / 100); },
      contact::makeFriction("Tresca", {[](Vec2 x) { return 0.211 + 0.412 * x.x; }})};
  conditions.dirichlet["top"] = {[](Vec2) { return 0.0; }, [](Vec2) { return 0.0; }};
  conditions.neumann["left"] = {[](Vec2 x) { return 4 * (0.25 - x.y * x.y); }, {}};
  conditions.neumann["right"] = {{}, [](Vec2 x) { return -(0.5 + x.y); }};
  return {squareMesh(elements, degree),
          {500, 0.3, false},
          conditions,
          "Gauss-Legendre-Lagrange",
          {}};
}

double rounding(const Indicators& indicators, const contact::Solved& solved) {
  // as energies: squares of stresses over E
  const double size = Sliding::pressure * Sliding::pressure / solved.units.stress;
  return indicators.estimate() / std::sqrt(size);
}

}  // namespace

// Complementarity and slip are integrals of products, not squares: what rounding leaves
// of them shows as its root.
TEUCHOS_UNIT_TEST(ResidualEstimator, vanishesOnLinearSolutionsWithFrictionAndRollers) {
  for (int degree : {1, 3})
    for (double coefficient : {0.3, 0.0})
      for (const char* multiplier : {"Bernstein", "Biorthogonal"}) {
        const SolvedScene scene({squareMesh(2, degree), material,
                                 Sliding{coefficient}.conditions(), multiplier,
                                 test::suited(multiplier)});
        Indicators indicators = estimate(scene);
        out << multiplier << ", degree " << degree << ", coefficient " << coefficient
            << ": ";
        TEST_COMPARE(rounding(indicators, scene.solved()), <, 1e-6);
        for (Contributions& squares : indicators.squares)
          of(squares, Source::Complementarity) = of(squares, Source::Slip) = 0;
        TEST_COMPARE(rounding(indicators, scene.solved()), <, 1e-10);
      }
}

TEUCHOS_UNIT_TEST(ContactBody, refusesToStabiliseAMultiplierThatSharesNodes) {
  TEST_THROW(SolvedScene({squareMesh(2, 1), material, Sliding().conditions(),
                          "Biorthogonal", contact::Stabilization{}}),
             bem::InputError);
}

// The claim above would be empty if the estimator saw nothing.
TEUCHOS_UNIT_TEST(ResidualEstimator, seesASmallChangeOfAnyCondition) {
  const auto rises = [&](const Conditions& conditions) {
    const SolvedScene scene(
        {squareMesh(2, 1), material, conditions, "Bernstein", contact::Stabilization{}});
    return rounding(estimate(scene), scene.solved()) > 1e-5;
  };
  Conditions other = Sliding().conditions();
  other.neumann["right"].x = [](Vec2) { return 1e-3 * Sliding::pressure; };
  TEST_ASSERT(rises(other));
  other = Sliding().conditions();
  other.contact["bottom"].friction.fields = {[](Vec2) { return 0.3003; }};
  TEST_ASSERT(rises(other));
  other = Sliding().conditions();
  other.contact["bottom"].gap = [](Vec2 x) { return 1e-5 * x.x; };
  TEST_ASSERT(rises(other));
}

// As steps of a path, whose gaps and bounds follow time: places are shared, what is given is not.
TEUCHOS_UNIT_TEST(ResidualEstimator, ofSeveralStatesIsThatOfEach) {
  std::vector<std::unique_ptr<const SolvedScene>> scenes;
  for (int k = 0; k < 40; ++k) {
    SolvedScene::Input input = trescaScene(3, 2);
    input.conditions.contact["bottom"].gap = [k](Vec2 x) {
      return 1e-3 * (1 + k % 3) - 0.01 * std::abs(x.x);
    };
    scenes.push_back(std::make_unique<const SolvedScene>(input));
  }
  std::vector<contact::Solved> solved;
  for (const auto& scene : scenes)
    solved.push_back(scene->solved());
  std::vector<adaptivity::Estimated> states;
  for (std::size_t k = 0; k < scenes.size(); ++k)
    states.push_back({solved[k], scenes[k]->density()});
  const std::vector<Indicators> together = adaptivity::estimateResiduals(
      states, scenes.front()->lame(), {"Energy", 1}, test::processes());
  for (const std::size_t k : {0, 1, 2, 39}) {
    const Indicators alone = estimate(*scenes[k]);
    TEST_FLOATING_EQUALITY(together[k].estimate(), alone.estimate(), 1e-12);
    const bem::Vector elements = alone.elements();
    for (std::size_t e = 0; e < elements.size(); ++e)
      TEST_COMPARE(std::abs(together[k].elements()[e] - elements[e]), <=,
                   1e-12 * alone.estimate() * alone.estimate());
  }
  TEST_COMPARE(std::abs(together[0].estimate() / together[1].estimate() - 1), >, 1e-3);
}

// Uniform traction on the whole boundary is taken by the fixed motions: u = 0.
TEUCHOS_UNIT_TEST(ResidualEstimator, countsTheTractionsThatHoldFixedMotions) {
  Conditions conditions;
  for (const char* side : {"bottom", "right", "top", "left"})
    conditions.neumann[side] = {[](Vec2 x) { return 0.01 - 0.02 * x.y; },
                                [](Vec2 x) { return -0.03 + 0.02 * x.x; }};
  conditions.fix = {true, true, true};
  const SolvedScene scene(
      {squareMesh(2, 2), material, conditions, "Bernstein", contact::Stabilization{}});
  TEST_COMPARE(rounding(estimate(scene), scene.solved()), <, 1e-10);
}

TEUCHOS_UNIT_TEST(ResidualEstimator, onlyContactElementsHaveContactTerms) {
  const SolvedScene scene(trescaScene(4, 1));
  const Indicators indicators = estimate(scene);
  const bem::Mesh& mesh = scene.solved().space.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const Contributions& squares = indicators.squares[e];
    const bool touching = mesh.boundary(e) == "bottom";
    const bool free = mesh.boundary(e) == "left" || mesh.boundary(e) == "right";
    TEST_EQUALITY(squares[0] > 0, free);
    TEST_EQUALITY(squares[1] > 0, touching);
    TEST_COMPARE(squares[2], >, 0);
    if (!touching)
      TEST_EQUALITY(std::accumulate(squares.begin() + 3, squares.end(), 0.0), 0);
  }
}

TEUCHOS_UNIT_TEST(ResidualEstimator, residualFactorScalesTheThreeResidualsOnly) {
  const SolvedScene scene(trescaScene(3, 1));
  const Contributions one = estimate(scene, "Paper").sums();
  const Contributions tenth = estimate(scene, "Paper", 0.1).sums();
  for (std::size_t k = 0; k < one.size(); ++k)
    TEST_FLOATING_EQUALITY(tenth[k] + 1, (k < 3 ? 0.1 : 1.0) * one[k] + 1, 1e-14);
}

}  // namespace epafi
