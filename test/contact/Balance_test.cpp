// Forces and moments balance where rounding of the stiffness is far larger than the load,
// on any number of ranks.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/Form.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/body/IterativeRefinement.hpp"
#include "contact/results/Summary.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace epafi {

namespace {

using bem::Index;
using bem::Vector;
using Form = contact::Stabilization::Form;

struct Body {
  bem::Lame lame;
  bem::Space space;
  bem::SteklovPoincare stiffness;

  Body(double length, double nu, const std::vector<int>& elements)
      : lame({1, nu, false}),
        space(bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, length, 1)), elements,
                            2)),
        stiffness(bem::assembleOperators(space, lame)) {}
};

double zero(bem::Vec2) { return 0; }

/// Held at the left, sheared at the right, bent and pressed from above, far from a floor.
contact::Conditions cantilever(double load) {
  contact::Conditions conditions;
  conditions.dirichlet["left"] = {zero, zero};
  conditions.neumann["top"] = {zero, [=](bem::Vec2) { return -load; }};
  conditions.neumann["right"] = {[=](bem::Vec2) { return -load; }, zero};
  conditions.contact["bottom"] = {[](bem::Vec2) { return 1e3; }, nullptr, {}};
  return conditions;
}

contact::ContactBody problemOf(const Body& body, const contact::Conditions& conditions) {
  return contact::ContactBody(
      {body.space, body.stiffness, body.lame,
       bem::Units{body.space.mesh().outline().diameter(), 1}, conditions,
       contact::multiplierBasis("Gauss-Legendre-Lagrange"), test::projected()});
}

std::unique_ptr<const contact::DenseBody> denseBody(
    const Body& body, const contact::Conditions& conditions,
    const contact::MultiplierSpace& multiplier, bem::Units units,
    const contact::Stabilization& stabilization) {
  return contact::makeDenseBody({body.space, body.stiffness, body.lame, units, conditions,
                                 multiplier.basis(), stabilization},
                                multiplier,
                                std::make_shared<const contact::Holding>(
                                    contact::makeHolding(body.space, conditions)));
}

double worstImbalance(const Body& body, double load) {
  const contact::Conditions conditions = cantilever(load);
  const contact::ContactBody problem = problemOf(body, conditions);
  contact::State state;
  state.multiplier.assign(problem.multiplier().size(), 0.0);
  const Vector u = problem.displacement(state);
  const double length = body.space.mesh().outline().diameter();
  const contact::Summary summary =
      contact::summarize({body.space, problem, conditions, {length, 1}, state, u});
  const double force = std::hypot(summary.load.x, summary.load.y);
  return std::max(
      {std::abs(summary.load.x + summary.reaction.x) / force,
       std::abs(summary.load.y + summary.reaction.y) / force,
       std::abs(summary.load.moment + summary.reaction.moment) / (force * length)});
}

TEUCHOS_UNIT_TEST(Balance, slenderAndNearlyIncompressibleBodiesAreInEquilibrium) {
  TEST_COMPARE(worstImbalance(Body(100, 0.3, {100, 2, 100, 2}), 1e-6), <, 1e-13);
  TEST_COMPARE(worstImbalance(Body(2, 0.4999999, {8, 4, 8, 4}), 1e-3), <, 1e-13);
}

TEUCHOS_UNIT_TEST(Balance, rigidMotionsFeelNoForceOfAnyDisplacement) {
  const Body body(100, 0.3, {50, 2, 50, 2});
  const contact::Conditions conditions = cantilever(1);
  const contact::MultiplierSpace multiplier(
      body.space.mesh(), contact::multiplierBasis("Gauss-Legendre-Lagrange"), conditions);
  const auto dense = denseBody(body, conditions, multiplier, {100, 1}, test::projected());
  const bem::Matrix motions = body.space.rigidMotions();
  Vector u(body.space.displacements());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::sin(1.0 + static_cast<double>(i * i % 101));
  const Vector forces = dense->residual(Vector(u.size(), 0.0), u);
  const double size =
      std::sqrt(std::inner_product(forces.begin(), forces.end(), forces.begin(), 0.0));
  TEST_COMPARE(size, >, 0.1);
  for (Index k = 0; k < 3; ++k) {
    const double* motion = motions.column(k);
    TEST_COMPARE(std::abs(std::inner_product(forces.begin(), forces.end(), motion, 0.0)),
                 <, 1e-15 * size);
    const Vector none =
        dense->residual(Vector(u.size(), 0.0), Vector(motion, motion + motions.rows()));
    TEST_COMPARE(test::largest(none), <, 1e-16);
  }
}

TEUCHOS_UNIT_TEST(Balance, withoutStabilisationTheOperatorIsTheStiffness) {
  const Body body(2, 0.3, {8, 4, 8, 4});
  const contact::Conditions conditions = cantilever(1);
  const contact::MultiplierSpace multiplier(
      body.space.mesh(), contact::multiplierBasis("Gauss-Legendre-Lagrange"), conditions);
  const auto dense =
      denseBody(body, conditions, multiplier, {2, 1}, test::ofForm(Form::None));
  Vector u(body.space.displacements());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::cos(static_cast<double>(i * i % 37));
  const Vector left = dense->residual(body.stiffness.apply(u), u);
  for (const double rest : left)
    TEST_COMPARE(std::abs(rest), <, 1e-13);
}

/// A factor of 0.999 A for A: what is left falls by a thousand a step.
TEUCHOS_UNIT_TEST(Refinement, endsAtRounding) {
  int steps = 0;
  const Vector u = contact::refined({1e-3, 2}, [&](const Vector& now) {
    steps += 1;
    return Vector{(1 - now[0]) / 0.999, (2 - now[1]) / 0.999};
  });
  TEST_COMPARE(std::abs(u[0] - 1), <, 1e-11);
  TEST_EQUALITY(u[1], 2.0);
  TEST_COMPARE(steps, <=, 4);
  TEST_COMPARE(steps, >=, 3);
}

TEUCHOS_UNIT_TEST(Refinement, leavesACorrectionOfRoundingAsTheLast) {
  int steps = 0;
  const Vector u = contact::refined({1, 2}, [&](const Vector&) {
    steps += 1;
    return Vector{1e-14, -1e-14};
  });
  TEST_EQUALITY(steps, 1);
  TEST_COMPARE(std::abs(u[0] - 1 - 1e-14), <, 1e-15);
}

/// A factor that knows too little of A: corrections grow, or go back and forth.
TEUCHOS_UNIT_TEST(Refinement, endsWhereCorrectionsDoNotShrink) {
  for (const double growth : {-3.0, -1.0, -0.6, 0.6, 1.0, 3.0}) {
    double next = 0.1;
    const Vector u = contact::refined({1}, [&](const Vector&) {
      const double now = next;
      next *= growth;
      return Vector{now};
    });
    TEST_EQUALITY(u[0], 1.1);  // the first alone
  }
  const Vector u = contact::refined(
      {1}, [](const Vector&) { return Vector{std::numeric_limits<double>::infinity()}; });
  TEST_EQUALITY(u[0], 1.0);
}

/// A wedge of 5 degrees in contact up to its tip.
TEUCHOS_UNIT_TEST(ContactBody, aDefaultGammaGivesWayAndOneThatIsWrittenIsRefused) {
  const bem::Lame lame({1, 0.3, false});
  const bem::Loop wedge{{{0, 0}, {1, 0}, {1, 0.0875}}, {"bottom", "left", "top"}};
  const bem::Space space(bem::makeMesh(test::outlineOf(wedge), {8, 2, 8}, 1));
  const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame));
  contact::Conditions conditions;
  conditions.dirichlet["left"] = {zero, zero};
  conditions.contact["bottom"] = {zero, nullptr, {}};
  contact::Stabilization stabilization = test::projected();
  const auto used = [&] {
    return contact::ContactBody({space, stiffness, lame, bem::Units{1, 1}, conditions,
                                 contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                 stabilization})
        .coupling()
        .gamma0;
  };
  const double first = stabilization.firstGamma0();
  const double weakened = used();
  stabilization.gamma0 = first;
  double limit = 0;
  try {
    used();
  } catch (const contact::IndefiniteStiffness& refused) {
    TEST_EQUALITY(refused.gamma0, first);
    limit = refused.limitGamma0;
  }
  TEST_COMPARE(limit, >, 0);
  TEST_COMPARE(limit, <, first);
  TEST_FLOATING_EQUALITY(weakened, limit / 4, 1e-9);
  stabilization.gamma0 = 0.999 * limit;
  TEST_EQUALITY(used(), 0.999 * limit);
  stabilization.gamma0 = 1.001 * limit;
  TEST_THROW(used(), contact::IndefiniteStiffness);
}

}  // namespace

}  // namespace epafi
