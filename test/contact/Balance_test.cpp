// Forces and moments balance where rounding of the stiffness is far larger than the load,
// on any number of ranks.
#include "contact/results/Balance.hpp"

#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"
#include "contact/body/DenseBody.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace epafi {

namespace {

using bem::Index;
using bem::Vector;
using Form = contact::Stabilization::Form;

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

/// A beam of height one, or a block.
test::BodyScene body(double length, double nu, const std::vector<int>& elements,
                     double load, const contact::Stabilization& stabilization) {
  return test::BodyScene(
      {bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, length, 1)), elements, 2),
       {1, nu, false},
       cantilever(load),
       "Gauss-Legendre-Lagrange",
       stabilization});
}

std::shared_ptr<const contact::DenseBody> coupled(const test::BodyScene& scene,
                                                  const bem::SteklovPoincare& stiffness) {
  const contact::Opposite none(scene.units.length);
  const auto plain = contact::makeCouplings({&scene.space}, scene.multiplier, none);
  return contact::makeDenseBody(scene.input(stiffness), scene.multiplier, 0,
                                std::make_shared<const contact::Holding>(
                                    makeHolding(scene.space, scene.conditions)),
                                plain.front());
}

double worstImbalance(const test::BodyScene& scene) {
  const bem::SteklovPoincare stiffness = scene.dense();
  const contact::ContactSystem system({scene.input(stiffness)});
  const contact::ContactBody& problem = system.body(0);
  contact::State state;
  state.multiplier.assign(problem.multiplier().size(), 0.0);
  const Vector u = problem.displacement(state);
  const contact::Summary summary =
      contact::summarize({scene.space, problem, scene.conditions, scene.units, state, u});
  const double force = std::hypot(summary.load.x, summary.load.y);
  return std::max({std::abs(summary.load.x + summary.reaction.x) / force,
                   std::abs(summary.load.y + summary.reaction.y) / force,
                   std::abs(summary.load.moment + summary.reaction.moment) /
                       (force * scene.units.length)});
}

TEUCHOS_UNIT_TEST(Balance, slenderAndNearlyIncompressibleBodiesAreInEquilibrium) {
  TEST_COMPARE(worstImbalance(body(100, 0.3, {100, 2, 100, 2}, 1e-6, test::projected())),
               <, 1e-13);
  TEST_COMPARE(worstImbalance(body(2, 0.4999999, {8, 4, 8, 4}, 1e-3, test::projected())),
               <, 1e-13);
}

/// A block that its top presses onto a floor.
contact::Conditions pressed() {
  contact::Conditions conditions;
  conditions.dirichlet["top"] = {zero, [](bem::Vec2) { return -1e-3; }};
  conditions.contact["bottom"] = {zero, nullptr, {}};
  return conditions;
}

/// What of a state is said to be broken: 'b' the body, 'c' the contact forces.
std::string broken(const test::SolvedScene& scene, const contact::State& state,
                   const std::vector<contact::Summary>& summaries,
                   contact::Balance balance = contact::Balance({1}),
                   double tolerance = 0) {
  std::string result;
  for (const contact::Imbalance& imbalance :
       balance.of(scene.system(), scene.system().configuration(state), {scene.solved()},
                  summaries, tolerance))
    if (imbalance.isBroken())
      result += imbalance.body ? 'b' : 'c';
  return result;
}

TEUCHOS_UNIT_TEST(Balance, whatBreaksItIsSeen) {
  const test::SolvedScene scene(
      {bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, 1, 1)), {4, 4, 4, 4}, 1),
       {1, 0.3, false},
       pressed(),
       "Gauss-Lobatto-Lagrange",
       test::projected()});
  const contact::Solved solved = scene.solved();
  const contact::Summary summary = contact::summarize(solved);
  TEST_EQUALITY(broken(scene, solved.state, {summary}), "");
  const double force = summary.contact.y;
  TEST_COMPARE(force, >, 1e-4);
  // a pressure that the displacement does not know
  contact::State other = solved.state;
  for (double& pressure : other.multiplier)
    pressure *= 1 + 1e-7;
  const contact::Solved wrong{solved.space,       solved.problem, solved.conditions,
                              solved.units,       other,          solved.displacement,
                              solved.contactForce};
  TEST_EQUALITY(broken(scene, solved.state, {contact::summarize(wrong)}).front(), 'b');
  for (const double share : {1e-10, 1e-8}) {
    contact::Summary turned = summary;
    turned.reaction.moment += share * force;
    TEST_EQUALITY(broken(scene, solved.state, {turned}), share > 1e-9 ? "b" : "");
    contact::Summary off = summary;  // in balance, and pressed by nobody
    off.contact.x += share * force;
    off.reaction.x -= share * force;
    TEST_EQUALITY(broken(scene, solved.state, {off}), share > 1e-9 ? "c" : "");
  }
}

/// Pressed onto a floor by a load, the vertical motion free, the others fixed.
contact::Conditions loaded() {
  contact::Conditions conditions = pressed();
  conditions.dirichlet.clear();
  conditions.neumann["top"] = {zero, [](bem::Vec2) { return -1e-3; }};
  conditions.fix.x = conditions.fix.rotation = true;
  return conditions;
}

/// A body with a free motion may miss 2 ε stress l, here 2 ε F; one that is held, and the sum of
/// contact forces, may not.
TEUCHOS_UNIT_TEST(Balance, ofFreeMotionsIsSolvedToTheTolerance) {
  for (const bool isFree : {true, false}) {
    const test::SolvedScene scene(
        {bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, 1, 1)), {4, 4, 4, 4}, 1),
         {1, 0.3, false},
         isFree ? loaded() : pressed(),
         "Gauss-Lobatto-Lagrange",
         test::projected()});
    const contact::Solved solved = scene.solved();
    const contact::Summary summary = contact::summarize(solved);
    const auto told = [&](double share, double tolerance) {
      contact::Summary pushed = summary;
      pushed.reaction.y += share * summary.contact.y;
      return broken(scene, solved.state, {pushed}, contact::Balance({1}), tolerance);
    };
    TEST_EQUALITY(told(1e-5, 0), "b");
    TEST_EQUALITY(told(1e-5, 1e-6), "b");
    TEST_EQUALITY(told(1e-5, 1e-5), isFree ? "" : "b");
    TEST_EQUALITY(told(1e-4, 1e-5), "b");
    contact::Summary off = summary;
    off.contact.y += 1e-5 * summary.contact.y;
    off.reaction.y -= 1e-5 * summary.contact.y;
    TEST_EQUALITY(broken(scene, solved.state, {off}, contact::Balance({1}), 1e-3), "c");
  }
}

/// What is rounding beside the largest force of a path is not told of an unloaded step.
TEUCHOS_UNIT_TEST(Balance, ofAPathIsMeasuredByItsLargestForce) {
  const test::SolvedScene scene(
      {bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, 1, 1)), {4, 4, 4, 4}, 1),
       {1, 0.3, false},
       pressed(),
       "Gauss-Lobatto-Lagrange",
       test::projected()});
  const contact::Solved solved = scene.solved();
  contact::Balance balance({1});
  balance.of(scene.system(), scene.system().configuration(solved.state), {solved},
             {contact::summarize(solved)}, 0);
  contact::State none;
  none.multiplier.assign(solved.state.multiplier.size(), 0.0);
  const Vector still(solved.displacement.size(), 0.0);
  const contact::Solved unloaded{solved.space, solved.problem, solved.conditions,
                                 solved.units, none,           still};
  contact::Summary rounding;
  rounding.reaction.y = 1e-13;
  const auto told = [&](contact::Balance of) {
    contact::Configuration at = scene.system().configuration(none);
    at.displacements = {still};
    return of.of(scene.system(), at, {unloaded}, {rounding}, 0).front().isBroken();
  };
  TEST_ASSERT(!told(balance));
  TEST_ASSERT(told(contact::Balance({1})));
}

TEUCHOS_UNIT_TEST(Balance, rigidMotionsFeelNoForceOfAnyDisplacement) {
  const test::BodyScene scene = body(100, 0.3, {50, 2, 50, 2}, 1, test::projected());
  const bem::SteklovPoincare stiffness = scene.dense();
  const auto sprung = coupled(scene, stiffness);
  const bem::Matrix motions = scene.space.rigidMotions();
  Vector u(scene.space.displacements());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::sin(1.0 + static_cast<double>(i * i % 101));
  const Vector forces = sprung->residual(Vector(u.size(), 0.0), u);
  const double size =
      std::sqrt(std::inner_product(forces.begin(), forces.end(), forces.begin(), 0.0));
  TEST_COMPARE(size, >, 0.1);
  for (Index k = 0; k < 3; ++k) {
    const double* motion = motions.column(k);
    TEST_COMPARE(std::abs(std::inner_product(forces.begin(), forces.end(), motion, 0.0)),
                 <, 1e-15 * size);
    const Vector none =
        sprung->residual(Vector(u.size(), 0.0), Vector(motion, motion + motions.rows()));
    TEST_COMPARE(test::largest(none), <, 1e-16);
  }
}

TEUCHOS_UNIT_TEST(Balance, withoutStabilisationTheOperatorIsTheStiffness) {
  const test::BodyScene scene = body(2, 0.3, {8, 4, 8, 4}, 1, test::ofForm(Form::None));
  const bem::SteklovPoincare stiffness = scene.dense();
  Vector u(scene.space.displacements());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::cos(static_cast<double>(i * i % 37));
  for (const double rest : coupled(scene, stiffness)->residual(stiffness.apply(u), u))
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
  const bem::Loop wedge{{{0, 0}, {1, 0}, {1, 0.0875}}, {"bottom", "left", "top"}};
  contact::Conditions conditions;
  conditions.dirichlet["left"] = {zero, zero};
  conditions.contact["bottom"] = {zero, nullptr, {}};
  contact::Stabilization stabilization = test::projected();
  const auto used = [&] {
    const test::BodyScene scene({bem::makeMesh(test::outlineOf(wedge), {8, 2, 8}, 1),
                                 {1, 0.3, false},
                                 conditions,
                                 "Gauss-Legendre-Lagrange",
                                 stabilization});
    const bem::SteklovPoincare stiffness = scene.dense();
    return contact::ContactSystem({scene.input(stiffness)}).body(0).coupling().gamma0;
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
