// Twice the energies of a solution are the work of all that acts, each on its own displacement.
#include "contact/results/VirtualWork.hpp"

#include "Rectangle.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"
#include "contact/conditions/ParticularSolution.hpp"
#include "contact/results/Balance.hpp"
#include "contact/solve/DefectCorrection.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <string>

namespace epafi {

namespace {

using bem::Vec2;
using bem::Vector;
using contact::VirtualWork;
using Form = contact::Stabilization::Form;

/// Pressed at the bottom and, farther, at the right by loads that lean.
contact::Conditions pressed() {
  contact::Conditions conditions;
  conditions.neumann["top"] = {[](Vec2 x) { return 1e-3 * x.x; },
                               [](Vec2 x) { return -1e-2 * (1 + x.x); }};
  const auto friction = contact::makeFriction("Coulomb", {[](Vec2) { return 0.3; }});
  conditions.contact["bottom"] = {[](Vec2 x) { return 2e-3 * x.x * x.x; }, friction};
  conditions.contact["right"] = {[](Vec2) { return -1e-3; }, friction};
  return conditions;
}

contact::Conditions fixed(const contact::Conditions::Fix& fix) {
  contact::Conditions conditions = pressed();
  conditions.fix = fix;
  return conditions;
}

/// Of a side that is bent, pressed down and sheared.
contact::Conditions clamped(bool alongX) {
  contact::Conditions conditions = pressed();
  conditions.dirichlet["left"] = {[](Vec2 x) { return 1e-3 * (1 + x.y); }, {}};
  if (!alongX)
    conditions.dirichlet["left"].y = [](Vec2 x) { return -2e-3 * std::cos(x.y); };
  return conditions;
}

contact::Conditions guided() {
  contact::Conditions conditions = clamped(true);
  conditions.fix.y = true;
  return conditions;
}

contact::BodyLoadSolution weight(double ratio) {
  contact::BodyLoads loads;
  loads.uniform = {4e-3, -1e-2};
  loads.linear = {2e-2, 1e-3};
  loads.temperature = {{0, 0, 1e-2}, {1, 1, 2e-2}};
  loads.expansion = 0.2;
  return std::make_shared<const contact::ParticularSolution>(
      loads, bem::Lame({1, ratio, false}));
}

test::SolvedScene solved(contact::Conditions conditions, Form form, bool isBent,
                         bool isHeavy, double ratio = 0.3) {
  if (isHeavy)
    conditions.inside = weight(ratio);
  bem::Loop loop = test::rectangle({-0.3, 0.1}, 0.7, 0.5);
  if (isBent)
    loop.bulges = {0.05, 0, 0.3, 0};
  return test::SolvedScene(
      {bem::makeMesh(test::outlineOf(loop), {3, 2, 2, 2}, 2),
       {1, ratio, false},
       conditions,
       form == Form::None ? "Biorthogonal" : "Gauss-Legendre-Lagrange",
       test::ofForm(form)});
}

/// What of a state is said to be broken, by its forces and by its work.
std::string broken(const test::SolvedScene& scene, const contact::Configuration& at,
                   double tolerance = 0) {
  contact::Balance balance({1 - 2 * scene.lame().nu});
  const contact::Solved solved = scene.solved();
  const contact::Solved there{solved.space,       solved.problem, solved.conditions,
                              solved.units,       at.state,       at.displacements[0],
                              at.contactForces[0]};
  std::string result;
  for (const contact::Imbalance& imbalance :
       balance.of(scene.system(), at, {there}, {contact::summarize(there)}, tolerance))
    result += imbalance.isBroken() ? "f" : "";
  return result +
         (balance.workOf(scene.system(), at, {1}, tolerance).isBroken() ? "w" : "");
}

TEUCHOS_UNIT_TEST(VirtualWork, isTwiceTheEnergies) {
  const std::pair<const char*, contact::Conditions> cases[] = {
      {"fixed", fixed({true, true, true})},
      {"free to fall", fixed({true, false, true})},
      {"clamped", clamped(false)},
      {"free along its clamp", clamped(true)},
      {"fixed along its clamp", guided()}};
  for (const auto& [name, conditions] : cases)
    for (const Form form : {Form::Density, Form::Projected, Form::Exact, Form::None})
      for (const bool isBent : {false, true})
        for (const bool isHeavy : {false, true}) {
          out << name << ", form " << static_cast<int>(form) << (isBent ? ", bent" : "")
              << (isHeavy ? ", heavy" : "") << "\n";
          const test::SolvedScene scene = solved(conditions, form, isBent, isHeavy);
          const contact::Configuration at =
              contact::corrected(scene.system(), scene.solved().state, bem::oneProcess());
          const VirtualWork work = contact::virtualWork(scene.system(), at);
          TEST_COMPARE(work.strain, >, 1e-8);
          TEST_COMPARE(std::abs(work.given), >, 1e-9);
          TEST_COMPARE(std::abs(work.missing()), <, 2e-12 * work.size);
          TEST_FLOATING_EQUALITY(work.strain + work.stabilisation, 2 * at.storedEnergy(),
                                 1e-12);
          TEST_EQUALITY(broken(scene, at, 1e-12), "");
        }
}

/// A motion of what Fix holds, a displacement that loads do not cause: no force tells of either.
TEUCHOS_UNIT_TEST(VirtualWork, whatBreaksItIsSeen) {
  const test::SolvedScene scene =
      solved(fixed({true, true, true}), Form::Density, false, false);
  const contact::Configuration at = scene.system().configuration(scene.solved().state);
  TEST_EQUALITY(broken(scene, at), "");
  const contact::Holding& holding = scene.system().body(0).holding();
  const double size = bem::largestEntry(at.displacements[0]);
  const auto asItIs = [&](const contact::Configuration& changed) {
    return scene.system().withResults(changed);
  };
  for (const double share : {1e-12, 1e-6}) {
    contact::Configuration moved = at;
    bem::axpy(share * size, bem::columnOf(holding.allowed, 1), moved.displacements[0]);
    TEST_EQUALITY(broken(scene, asItIs(moved)), share > 1e-9 ? "w" : "");
    contact::Configuration bent = at;
    bem::axpy(share, bem::Vector(at.displacements[0]), bent.displacements[0]);
    TEST_EQUALITY(broken(scene, asItIs(bent)), share > 1e-9 ? "w" : "");
    contact::Configuration stored = at;
    for (double& pressure : stored.state.multiplier)
      pressure *= 1 + share;
    TEST_EQUALITY(broken(scene, asItIs(stored)).find('w') != std::string::npos,
                  share > 1e-9);
  }
}

/// No less without compression, where forces have fewer digits.
TEUCHOS_UNIT_TEST(VirtualWork, whatBreaksItIsSeenWithoutCompression) {
  const test::SolvedScene scene =
      solved(fixed({true, true, true}), Form::Density, false, false, 0.5);
  contact::Configuration at = scene.system().configuration(scene.solved().state);
  TEST_EQUALITY(broken(scene, at), "");
  const VirtualWork work = contact::virtualWork(scene.system(), at);
  TEST_COMPARE(std::abs(work.missing()), <, 1e-12 * work.size);
  bem::axpy(5e-9, bem::Vector(at.displacements[0]), at.displacements[0]);
  TEST_EQUALITY(broken(scene, scene.system().withResults(at)), "w");
}

}  // namespace

}  // namespace epafi
