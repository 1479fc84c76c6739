// Steps of a path: one problem at many times, and what friction remembers of them.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/ProblemFamily.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/path/Prediction.hpp"
#include "contact/solve/Settled.hpp"
#include "contact/system/LoadResponses.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace epafi {

namespace {

using bem::Vec2;
using contact::State;
using contact::Vector;
using test::largest;
using test::largestDifference;
using Form = contact::Stabilization::Form;

/// The conditions of the only body.
std::vector<contact::Conditions> alone(contact::Conditions conditions) {
  return {std::move(conditions)};
}

/// A unit square that stands on a plane: its top moves down, then to and fro, while the plane rises
/// and its right side is pushed; t in [0, 4].
contact::Conditions conditionsAt(double t) {
  contact::Conditions conditions;
  const double down = -0.01 * std::min(t, 1.0);
  const double along = t < 1 ? 0.0 : 0.02 * std::sin(1.5 * (t - 1));
  conditions.contact["bottom"] = {
      [t](Vec2 x) { return 0.004 * x.x - 0.001 * t; },
      contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }})};
  conditions.dirichlet["top"] = {[along](Vec2) { return along; },
                                 [down](Vec2) { return down; }};
  conditions.neumann["right"] = {[t](Vec2 x) { return -0.002 * t * x.y; }, {}};
  return conditions;
}

/// Pressed and pushed, the more the larger t: the solution is a multiple of t.
contact::Conditions inProportion(double t, double push = 0.003) {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      [](Vec2) { return 0.0; },
      contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }})};
  conditions.dirichlet["top"] = {[t, push](Vec2) { return push * t; },
                                 [t](Vec2) { return -0.01 * t; }};
  return conditions;
}

/// The square's problem under the conditions at a time.
struct Square : test::BodyScene {
  bem::SteklovPoincare stiffness = dense();
  contact::ContactSystem problem = contact::ContactSystem({input(stiffness)});

  Square(Form form, double time)
      : BodyScene({test::squareMesh({6, 4, 6, 4}, 2),
                   {1, 0.3, false},
                   conditionsAt(time),
                   "Gauss-Legendre-Lagrange",
                   test::ofForm(form)}) {}
};

}  // namespace

TEUCHOS_UNIT_TEST(Path, workAtTheMeanBoundIsExactInProportion) {
  using Shear = contact::PathMemory::Shear;
  const Square square(Form::Density, 0);
  const auto none = alone(inProportion(0));
  const contact::ContactSystem problem = square.problem.under(none);
  const auto follow = [&](int steps, Shear shear) {
    contact::PathMemory memory(problem, shear);
    State state;
    for (int k = 1; k <= steps; ++k) {
      const auto now = alone(inProportion(4.0 * k / steps, 0.02));
      const contact::ContactSystem step = problem.under(now, {}, memory.forStep());
      state = test::solve(step.numbers(), state).state;
      memory.add(step, step.configuration(state));
    }
    return memory;
  };
  const double exact = follow(8, Shear::Mean).friction();
  TEST_COMPARE(exact, >, 1e-7);
  for (const int steps : {1, 3})
    TEST_FLOATING_EQUALITY(follow(steps, Shear::Mean).friction(), exact, 1e-8);
  // s r in place of ½ s r; of n steps 1 + 1/n times as much
  TEST_FLOATING_EQUALITY(follow(1, Shear::AtEnd).friction(), 2 * exact, 1e-8);
  TEST_FLOATING_EQUALITY(follow(4, Shear::AtEnd).friction(), 1.25 * exact, 1e-8);

  const auto apart = follow(1, Shear::Mean).apart(follow(3, Shear::Mean));
  TEST_COMPARE(apart.work, <, 1e-8 * exact);
  TEST_COMPARE(apart.slip, <, 1e-8 * exact);
  TEST_COMPARE(follow(1, Shear::AtEnd).apart(follow(4, Shear::AtEnd)).work, >,
               0.7 * exact);
}

/// A plane that rises by δ against a body that Fix holds does ½ F δ, and the body stores it, whatever γ.
TEUCHOS_UNIT_TEST(Path, whatFixHoldsDoesNoWork) {
  const auto at = [](double t) {
    contact::Conditions conditions;
    conditions.fix = {true, true, true};
    conditions.contact["bottom"].gap = [t](Vec2) { return -0.002 * t; };
    return conditions;
  };
  for (const Form form : {Form::Density, Form::Projected, Form::Exact})
    for (const double gamma0 : {0.1, 10.0}) {
      if (gamma0 > 1 && form != Form::Density)
        continue;
      contact::Stabilization stabilization = test::ofForm(form);
      stabilization.gamma0 = gamma0;
      const test::BodyScene scene({test::squareMesh({6, 3, 6, 3}, 2),
                                   {1, 0.3, false},
                                   at(0),
                                   "Gauss-Legendre-Lagrange",
                                   stabilization});
      const bem::SteklovPoincare stiffness = scene.dense();
      const contact::ContactSystem system({scene.input(stiffness)});
      contact::PathMemory memory(system);
      const auto now = alone(at(1));
      const contact::ContactSystem step = system.under(now, {}, memory.forStep());
      const contact::Configuration solved =
          step.configuration(test::solve(step.numbers()).state);
      memory.add(step, solved);
      const double traction = step.body(0).fixedReactions(solved.contactForces[0])[1];
      const double length = 1 / scene.units.length;  // of a side
      const double work = 0.5 * (-traction * 4 * length) * 0.002 * length;
      TEST_COMPARE(work, >, 1e-6);
      TEST_FLOATING_EQUALITY(memory.outside(), work, 1e-12);
      TEST_COMPARE(std::abs(memory.imbalance(solved.storedEnergy())), <, 1e-12 * work);
    }
}

/// States alone give what wore along a path, also where Fix carries friction: a restart.
TEUCHOS_UNIT_TEST(Path, goesOnFromItsStates) {
  const auto at = [](double t) {
    contact::Conditions conditions;
    conditions.fix.x = true;
    conditions.neumann["top"] = {{}, [t](Vec2) { return -0.02 * std::min(t, 1.0); }};
    contact::Conditions::Contact& bottom = conditions.contact["bottom"];
    bottom.gap = [](Vec2) { return 0.0; };
    bottom.friction = contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }});
    bottom.sliding = [t](Vec2) { return 0.02 * std::sin(1.5 * std::max(0.0, t - 1)); };
    bottom.wear = [](Vec2) { return 2.0; };
    return conditions;
  };
  const test::BodyScene scene({test::squareMesh({8, 4, 8, 4}, 1),
                               {1, 0.3, false},
                               at(0),
                               "Gauss-Legendre-Lagrange",
                               {}});
  const bem::SteklovPoincare stiffness = scene.dense();
  const contact::ContactSystem system({scene.input(stiffness)});
  std::vector<State> states;
  const auto follow = [&](bool isKnown) {
    contact::PathMemory memory(system);
    for (std::size_t k = 0; k < 9; ++k) {
      const auto now = alone(at(1 + 0.4 * static_cast<double>(k)));
      contact::ContactSystem step = system.under(now, {}, memory.forStep());
      const auto solve = [&](const State* before) {
        return test::solve(step.numbers(), before != nullptr ? *before : State());
      };
      const contact::Configuration solved =
          isKnown ? contact::worn(step, step.configuration(states[k]))
                  : contact::settled(step, solve, bem::oneProcess()).at;
      if (!isKnown)
        states.push_back(solved.state);
      memory.add(step, solved);
    }
    return memory;
  };
  const contact::PathMemory solved = follow(false);
  const contact::PathMemory known = follow(true);
  TEST_COMPARE(solved.worn(), >, 1e-6);
  TEST_FLOATING_EQUALITY(known.worn(), solved.worn(), 1e-11);
  TEST_FLOATING_EQUALITY(known.outside(), solved.outside(), 1e-11);
  TEST_COMPARE(known.apart(solved).volume, <, 1e-11 * solved.wornVolume());
}

TEUCHOS_UNIT_TEST(Path, boundsThatStayCountFromTheFirstStepOn) {
  using Shear = contact::PathMemory::Shear;
  const auto at = [](double t) {
    contact::Conditions conditions = inProportion(t, 0.02);
    conditions.contact["bottom"].friction =
        contact::makeFriction("Tresca", {[](Vec2) { return 0.001; }});
    return conditions;
  };
  const Square square(Form::Density, 0);
  const auto none = alone(at(0));
  const contact::ContactSystem problem = square.problem.under(none);
  const auto now = alone(at(1));
  const contact::ContactSystem step = problem.under(now);
  const contact::Configuration solved =
      step.configuration(test::solve(step.numbers(), {}).state);
  contact::PathMemory atEnd(problem);
  contact::PathMemory mean(problem, Shear::Mean);
  atEnd.add(step, solved);
  mean.add(step, solved);
  TEST_COMPARE(atEnd.friction(), >, 1e-7);
  TEST_FLOATING_EQUALITY(mean.friction(), atEnd.friction(), 1e-12);
}

TEUCHOS_UNIT_TEST(Path, aStepBeginsOnTheLineThroughTheLastTwo) {
  const Square square(Form::Projected, 0);
  const auto none = alone(inProportion(0));
  const contact::ContactSystem problem = square.problem.under(none);
  contact::PathMemory memory(problem);
  contact::Prediction prediction(problem);
  double size = 0;
  for (const double t : {1.0, 1.5, 4.0, 2.0}) {
    const auto now = alone(inProportion(t));
    const contact::ContactSystem step = problem.under(now, {}, memory.forStep());
    const State start = prediction.start(step);
    if (t == 1) {
      TEST_ASSERT(start.multiplier.empty());
    } else if (t == 2) {  // the load turns back
      TEST_ASSERT(start.multiplier == prediction.last().multiplier);
      break;
    }
    const State state = test::solve(step.numbers(), start).state;
    size = std::max(size, largest(state.multiplier));
    if (t > 1)
      TEST_COMPARE(largestDifference(start.multiplier, state.multiplier), <, 1e-9 * size);
    memory.add(step, step.configuration(state));
    prediction.add(step, state);
  }
  TEST_COMPARE(size, >, 1e-3);
}

TEUCHOS_UNIT_TEST(Path, theIncrementLeadsFromTheStepBeforeToThisOne) {
  const Square square(Form::Projected, 1);
  const contact::ContactSystem& system = square.problem;
  const auto before = alone(conditionsAt(1));
  const auto now = alone(conditionsAt(1.5));
  contact::PathMemory memory(system);
  const contact::ContactSystem first = system.under(before);
  const State state = test::solve(first.numbers(), {}).state;
  memory.add(first, first.configuration(state));
  const contact::ContactSystem last = system.under(before, {}, memory.forStep());
  const contact::ContactSystem step = system.under(now, {}, memory.forStep());
  const contact::ProblemFamily family(step.numbers(), step.gap(), last.numbers());
  TEST_ASSERT(family.isStep());

  // the step before is solved by its own state, friction included, and not by another part
  const auto residual = [&](double s, const Vector& x) {
    const contact::Problem problem = family.at({1, 1, s});
    return contact::Equation(problem, contact::Equation::Bound::Differentiated, 0)
        .at(x)
        .residual;
  };
  const Vector x = contact::pack(step.numbers(), state);
  TEST_COMPARE(largest(residual(0, x)), <, 1e-10 * step.numbers().stress);
  TEST_COMPARE(largest(residual(1, x)), >, 1e-4 * step.numbers().stress);

  const contact::Problem middle = family.at({1, 1, 0.5});
  const contact::Equation equation = test::equationOf(middle, 0);
  const contact::Evaluation e = equation.at(x);
  const Vector derivative = family.incrementDerivative(equation, e);
  constexpr double h = 1e-6;
  const Vector above = residual(0.5 + h, x);
  const Vector below = residual(0.5 - h, x);
  for (std::size_t i = 0; i < derivative.size(); ++i)
    TEST_COMPARE(std::abs((above[i] - below[i]) / (2 * h) - derivative[i]), <=,
                 1e-6 * (largest(derivative) + 1e-12));
  TEST_THROW(contact::ProblemFamily(step.numbers(), step.gap()).at({1, 1, 0.5}),
             bem::InputError);
}

TEUCHOS_UNIT_TEST(LoadResponses, ofCombinationsNeedFewSolutions) {
  const auto loadAt = [](double t, double across) {
    Vector load;
    for (int j = 0; j < 50; ++j)
      load.push_back(std::cos(0.3 * j) + t * std::sin(0.9 * j) + across * j);
    return load;
  };
  const auto image = [](const Vector& load) {
    Vector result(7, 0.0);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (std::size_t j = 0; j < load.size(); ++j)
        result[i] +=
            std::sin(1.7 * static_cast<double>(i) + static_cast<double>(j)) * load[j];
    return result;
  };
  contact::LoadResponses responses;
  int solved = 0;
  const auto responseTo = [&](const Vector& load) {
    return responses.of(load, [&] {
      ++solved;
      return image(load);
    });
  };
  for (int step = 0; step <= 40; ++step) {
    const Vector load = loadAt(step < 30 ? 0.1 * step : 6 - 0.1 * step, 0);
    const Vector response = responseTo(load);
    const Vector exact = image(load);
    for (std::size_t i = 0; i < exact.size(); ++i)
      TEST_COMPARE(std::abs(response[i] - exact[i]), <, 1e-12);
  }
  TEST_COMPARE(solved, <=, 6);
  // another direction, though by little, is another load
  const int before = solved;
  responseTo(loadAt(1, 1e-12));
  TEST_EQUALITY(solved, before + 1);
}

}  // namespace epafi
