// The condensed contact problem is the same on any number of ranks, in all its numbers
// and in what is computed back from its solution.
#include "Projected.hpp"
#include "bem/base/Error.hpp"
#include "bem/tpetra/DistributedRows.hpp"
#include "contact/results/Summary.hpp"
#include "contact/system/Definiteness.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using bem::Index;
using bem::Vector;
using contact::Stabilization;
using test::difference;

const bem::LapackAlgebra lapack;
const bem::Lame lame({1, 0.3, false});
const bem::Units units{1, 1};

/// A square block that is pressed onto a rough floor from above.
contact::Conditions pressedBlock(const char* law) {
  contact::Conditions conditions;
  conditions.neumann["top"] = {[](bem::Vec2) { return 0.001; },
                               [](bem::Vec2 x) { return -0.01 * (1 + x.x); }};
  conditions.contact["bottom"] = {
      [](bem::Vec2 x) { return 0.001 * x.x * x.x; },
      law == std::string("None")
          ? contact::Friction()
          : contact::makeFriction(law, {[](bem::Vec2) { return 0.3; }})};
  return conditions;
}

contact::Conditions clampedBlock(const char* law) {
  contact::Conditions conditions = pressedBlock(law);
  conditions.dirichlet["left"] = {[](bem::Vec2 x) { return 0.001 * x.y; },
                                  [](bem::Vec2) { return 0.0; }};
  return conditions;
}

contact::Conditions heldBlock(const char* law) {
  contact::Conditions conditions = pressedBlock(law);
  conditions.fix.x = conditions.fix.rotation = true;
  return conditions;
}

bem::Mesh blockMesh(const std::vector<int>& elements, int degree) {
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"bottom", "right", "top", "left"}};
  return bem::makeMesh(
      std::make_shared<const bem::Outline>(square, std::vector<bem::Loop>{}), elements,
      degree);
}

/// Everything that somebody takes from a problem.
struct Numbers {
  contact::Problem problem;
  Vector displacement;
  Vector clampWork;
  contact::Summary summary;
};

Numbers numbersOf(const bem::Mesh& mesh, const contact::Conditions& conditions,
                  Stabilization::Form form, const bem::DenseAlgebra& algebra) {
  Stabilization stabilization;
  stabilization.form = form;
  const contact::MultiplierBasis& basis =
      contact::multiplierBasis("Gauss-Legendre-Lagrange");
  const bem::Space space = contact::makeSpace(mesh, conditions, stabilization);
  const bem::SteklovPoincare stiffness = contact::makeStiffness(
      space, contact::MultiplierSpace(space.mesh(), basis, conditions), stabilization,
      lame, units, algebra);
  const contact::ContactProblem problem(
      {space, stiffness, lame, units, conditions, basis, stabilization});
  contact::State state;
  for (Index i = 0; i < problem.numbers().size(); ++i)
    state.multiplier.push_back(0.01 * std::sin(static_cast<double>(i)));
  state.rigid.assign(problem.numbers().rigidLoad.size(), 0.02);
  Numbers numbers;
  numbers.displacement = problem.displacement(state);
  numbers.clampWork = problem.clampWork(state, numbers.displacement);
  numbers.summary = contact::summarize(
      {space, stiffness, problem, conditions, units, state, numbers.displacement});
  numbers.problem = problem.numbers().copy();
  return numbers;
}

TEUCHOS_UNIT_TEST(DistributedProblem, isTheSameOnAnyNumberOfRanks) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  struct Case {
    std::vector<int> elements;
    contact::Conditions conditions;
    int degree;
    Stabilization::Form form;
  };
  using Form = Stabilization::Form;
  const Case cases[] = {
      {{8, 3, 4, 5}, pressedBlock("Coulomb"), 1, Form::Projected},
      {{8, 3, 4, 5}, clampedBlock("Tresca"), 1, Form::Exact},
      {{6, 2, 3, 2}, heldBlock("Coulomb"), 3, Form::Projected},
      {{6, 2, 3, 2}, heldBlock("Coulomb"), 3, Form::Density},
      {{2, 1, 1, 1}, clampedBlock("None"), 6, Form::None},
      {{20, 20, 20, 20}, heldBlock("Tresca"), 1, Form::Exact},
  };
  for (const Case& c : cases) {
    const bem::Mesh mesh = blockMesh(c.elements, c.degree);
    const Numbers one = numbersOf(mesh, c.conditions, c.form, lapack);
    const Numbers all = numbersOf(mesh, c.conditions, c.form, algebra);
    TEST_COMPARE(difference(lapack, all.problem.flexibility.entries(),
                            one.problem.flexibility.entries()),
                 <, 1e-12);
    TEST_COMPARE(difference(lapack, all.problem.rigid, one.problem.rigid), <, 1e-12);
    TEST_COMPARE(difference(all.problem.offset, one.problem.offset), <, 1e-12);
    TEST_COMPARE(difference(all.problem.rigidLoad, one.problem.rigidLoad), <, 1e-12);
    TEST_COMPARE(difference(all.displacement, one.displacement), <, 1e-12);
    TEST_COMPARE(difference(all.clampWork, one.clampWork), <, 1e-12);
    const auto scalars = [](const contact::Summary& s) {
      return Vector{s.energyStrain, s.energyLoad,      s.load.x,         s.load.y,
                    s.load.moment,  s.contact.x,       s.contact.y,      s.reaction.x,
                    s.reaction.y,   s.reaction.moment, s.contact.moment, s.contactLength,
                    s.slipLength};
    };
    TEST_COMPARE(difference(scalars(all.summary), scalars(one.summary)), <, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(DistributedProblem, isRefusedOnAllRanksWhereGammaIsTooLarge) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const bem::Space space(blockMesh({8, 8, 8, 8}, 1));
  const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame, algebra, {}),
                                       algebra);
  const contact::Conditions conditions = clampedBlock("None");
  Stabilization stabilization = test::projected();
  stabilization.gamma0 = 5;
  TEST_THROW(contact::ContactProblem({space, stiffness, lame, units, conditions,
                                      contact::multiplierBasis("Gauss-Legendre-Lagrange"),
                                      stabilization}),
             bem::NumericalError);
}

TEUCHOS_UNIT_TEST(DistributedProblem, defaultGammaGivesWayAlikeOnAllRanks) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  // a wedge of 5 degrees in contact up to its tip
  const bem::Loop wedge{{{0, 0}, {1, 0}, {1, 0.0875}}, {"bottom", "left", "top"}};
  const bem::Space space(
      bem::makeMesh(std::make_shared<const bem::Outline>(wedge, std::vector<bem::Loop>{}),
                    {8, 2, 8}, 1));
  const contact::Conditions conditions = clampedBlock("None");
  const auto gamma0 = [&](const bem::DenseAlgebra& on, Stabilization stabilization) {
    const bem::SteklovPoincare stiffness(bem::assembleOperators(space, lame, on, {}), on);
    const contact::ContactProblem::Input input{
        space,        stiffness,  lame,
        units,        conditions, contact::multiplierBasis("Gauss-Legendre-Lagrange"),
        stabilization};
    const double used = contact::ContactProblem(input).gamma0();
    TEST_FLOATING_EQUALITY(used, contact::limitGamma0(input) / 4, 1e-9);
    return used;
  };
  const double used = gamma0(algebra, test::projected());
  TEST_COMPARE(used, <, 0.1 / 4);
  TEST_FLOATING_EQUALITY(used, gamma0(lapack, test::projected()), 1e-9);
  TEST_EQUALITY(algebra.broadcast({used}).front(), used);
  Stabilization written = test::projected();
  written.gamma0 = written.firstGamma0();
  TEST_THROW(gamma0(algebra, written), contact::IndefiniteStiffness);
}

}  // namespace

}  // namespace epafi
