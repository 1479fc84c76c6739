#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/SolvedScene.hpp"
#include "contact/equation/ProblemFamily.hpp"
#include "contact/nox/ContactModel.hpp"

#include <NOX.H>
#include <NOX_Thyra.H>
#include <Teuchos_UnitTestHarness.hpp>

#include <LOCA.H>
#include <LOCA_Thyra.H>
#include <cmath>

namespace {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
namespace test = epafi::test;
using bem::Vec2;
using contact::Index;
using contact::Vector;
using epafi::test::largest;
using epafi::test::largestDifference;

// A block over a curved foundation, its top pulled, pushed and displaced by `load`; with
// or without a clamp.
contact::Conditions conditionsFor(double load, bool clamped, double coefficient) {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      [](Vec2 x) { return 0.01 + 0.05 * x.x * x.x; },
      contact::makeFriction("Coulomb", {[coefficient](Vec2) { return coefficient; }})};
  conditions.neumann["right"] = {[load](Vec2 x) { return load * 0.3 * x.y; },
                                 [load](Vec2) { return -load * 0.1; }};
  if (clamped) {
    conditions.dirichlet["top"] = {[load](Vec2 x) { return load * 0.02 * x.x; },
                                   [load](Vec2) { return -load * 0.04; }};
  } else {
    conditions.neumann["top"] = {{}, [load](Vec2) { return -load; }};
    conditions.fix.x = true;
    conditions.fix.rotation = true;
  }
  return conditions;
}

test::SolvedScene solvedBlock(double load, bool clamped, double coefficient = 0.4) {
  return test::SolvedScene(
      {bem::makeMesh(test::outlineOf(test::rectangle({-1, 0}, 2, 1)), {4, 2, 3, 2}, 2),
       bem::Material{5, 0.3, false},
       conditionsFor(load, clamped, coefficient),
       "Gauss-Legendre-Lagrange",
       {}});
}

/// A load factor is one of all tractions and prescribed displacements over the same gap.
TEUCHOS_UNIT_TEST(LoadFactor, scalesTractionsAndPrescribedDisplacements) {
  for (const bool clamped : {false, true}) {
    const auto scene = solvedBlock(1, clamped);
    const contact::ContactSystem& one = scene.system();
    TEST_COMPARE(largest(one.gap()), >, 1e-4);
    const contact::ProblemFamily family(one.numbers(), one.gap());
    for (const double load : {0.0, 2.0}) {
      const auto other = solvedBlock(load, clamped);
      const contact::Problem& expected = other.system().numbers();
      const contact::Problem scaled = family.at({load, 1});
      TEST_COMPARE(largestDifference(scaled.offset, expected.offset), <,
                   1e-13 * largest(expected.offset));
      TEST_COMPARE(largestDifference(scaled.rigidLoad, expected.rigidLoad), <, 1e-14);
    }
  }
}

/// What doc/howto/embed.md says of the displacement at another load factor.
TEUCHOS_UNIT_TEST(LoadFactor, displacementAddsTheRestOfTheLoad) {
  for (const bool clamped : {false, true}) {
    const auto scene = solvedBlock(1, clamped);
    const auto twice = solvedBlock(2, clamped);
    const contact::ContactBody& one = scene.system().body(0);
    const contact::ContactBody& two = twice.system().body(0);
    const contact::State& state = twice.solved().state;
    Vector u = one.displacement(state);
    const Vector rest = one.displacement({});
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += rest[i];
    const Vector expected = two.displacement(state);
    TEST_COMPARE(largestDifference(u, expected), <, 1e-12 * largest(expected));
  }
}

/// The friction factor is one of the coefficient, also where Fix carries friction: what follows it
/// solves the problem that a program of that coefficient solves.
TEUCHOS_UNIT_TEST(LoadFactor, ofFrictionIsAnotherCoefficient) {
  for (const bool clamped : {false, true}) {
    const auto scene = solvedBlock(1, clamped);
    const auto less = solvedBlock(1, clamped, 0.1);
    const contact::ContactSystem& system = scene.system();
    const contact::ProblemFamily family(system.numbers(), system.gap());
    const contact::State state = test::solve(family.at({1, 0.25})).state;
    const Vector& expected = less.solved().state.multiplier;
    TEST_COMPARE(largestDifference(expected, scene.solved().state.multiplier), >,
                 1e-2 * largest(expected));
    TEST_COMPARE(largestDifference(state.multiplier, expected), <,
                 1e-10 * largest(expected));
    if (!clamped)
      TEST_COMPARE(std::abs(less.system().body(0).fixedReactions(
                       less.system().body(0).contactForce(expected))[0]),
                   >, 1e-3);
  }
}

/// Four elements of degree one on each side, a load that leans and is not symmetric.
test::SolvedScene leaningBlock(double coefficient) {
  contact::Conditions conditions = conditionsFor(1, false, coefficient);
  conditions.neumann["left"] = {[](Vec2) { return 0.05; }, {}};
  return test::SolvedScene(
      {bem::makeMesh(test::outlineOf(test::rectangle({-1, 0}, 2, 1)), {4, 4, 4, 4}, 1),
       bem::Material{5, 0.3, false},
       conditions,
       "Gauss-Legendre-Lagrange",
       {}});
}

/// Keeps what LOCA finds.
class Recorder final : public LOCA::Thyra::SaveDataStrategy {
 public:
  explicit Recorder(Teuchos::RCP<const contact::ContactModel> model)
      : model_(std::move(model)) {}

  void saveSolution(const NOX::Abstract::Vector& x, double factor) override {
    const auto& vector = Teuchos::dyn_cast<const NOX::Thyra::Vector>(x);
    path.emplace_back(factor, model_->state(vector.getThyraVector()));
  }

  std::vector<std::pair<double, contact::State>> path;

 private:
  Teuchos::RCP<const contact::ContactModel> model_;
};

/// LOCA's natural continuation over the friction factor, from 0.4 to 0.1.
TEUCHOS_UNIT_TEST(LoadFactor, continuationSolvesWhatAProgramOfEachCoefficientSolves) {
  const auto scene = leaningBlock(0.4);
  const auto model = Teuchos::rcp(new contact::ContactModel(scene.system()));
  const auto list = Teuchos::parameterList();
  list->sublist("NOX").sublist("Line Search").set("Method", "Full Step");
  list->sublist("NOX").sublist("Printing").set("Output Information", 0);
  Teuchos::ParameterList& loca = list->sublist("LOCA");
  loca.sublist("Stepper")
      .set("Continuation Method", "Natural")
      .set("Continuation Parameter", "Friction Factor")
      .set("Initial Value", 1.0)
      .set("Min Value", 0.25)
      .set("Max Value", 1.0)
      .set("Max Steps", 10)
      .set("Max Nonlinear Iterations", 20)
      .set("Compute Eigenvalues", false);
  loca.sublist("Predictor").set("Method", "Constant");
  loca.sublist("Step Size").set("Method", "Constant").set("Initial Step Size", -0.25);
  const auto recorder = Teuchos::rcp(new Recorder(model));
  const auto data = LOCA::createGlobalData(list);
  {
    LOCA::ParameterVector factor;
    factor.addParameter("Friction Factor", 1.0);
    const auto group = Teuchos::rcp(new LOCA::Thyra::Group(
        data, NOX::Thyra::Vector(model->point(scene.solved().state)), model, factor,
        contact::ContactModel::Friction));
    group->setSaveDataStrategy(recorder);
    const auto test =
        Teuchos::rcp(new NOX::StatusTest::NormF(1e-12, NOX::StatusTest::NormF::Unscaled));
    TEST_EQUALITY(LOCA::Stepper(data, group, test, list).run(),
                  LOCA::Abstract::Iterator::Finished);
  }
  LOCA::destroyGlobalData(data);
  TEST_COMPARE(recorder->path.size(), >=, 4);
  for (const auto& [factor, state] : recorder->path) {
    const auto program = leaningBlock(0.4 * factor);
    const Vector& expected = program.solved().state.multiplier;
    TEST_COMPARE(largestDifference(state.multiplier, expected), <,
                 1e-9 * largest(expected));
    TEST_COMPARE(std::abs(program.system().body(0).fixedReactions(
                     program.system().body(0).contactForce(expected))[0]),
                 >, 1e-3);
  }
  TEST_FLOATING_EQUALITY(recorder->path.back().first, 0.25, 1e-12);
}

}  // namespace
