// What displacements leave of the conditions of contact: nothing but rounding on stocky bodies,
// and on slender ones what steps of correction take away.  On any number of ranks.
#include "contact/solve/DefectCorrection.hpp"

#include "Largest.hpp"
#include "Rectangle.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Classify.hpp"
#include "contact/equation/Equation.hpp"
#include "contact/path/PathMemory.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <iostream>

namespace epafi {

namespace {

using bem::Vec2;
using bem::Vector;
using contact::Stabilization;
using Form = Stabilization::Form;
using test::largest;

struct Case {
  double length;
  Form form;
  const char* basis;
  int degree;
  double bulge = 0;       ///< of the side in contact
  double friction = 0.3;  ///< coefficient
};

/// A body of height 1 on a plane: what presses it down varies along it, a push from the left.
struct Body : test::BodyScene {
  explicit Body(const Case& c)
      : BodyScene({meshOf(c),
                   {1, 0.3, false},
                   conditionsOf(c),
                   c.basis,
                   test::ofForm(c.form)}) {}

  contact::ContactSystem system(const bem::SteklovPoincare& stiffness) const {
    return contact::ContactSystem({input(stiffness)});
  }

 private:
  static bem::Mesh meshOf(const Case& c) {
    const int elements = static_cast<int>(4 * c.length);
    bem::Loop loop = test::rectangle({0, 0}, c.length, 1);
    if (c.bulge != 0)
      loop.bulges = {c.bulge, 0, 0, 0};
    return bem::makeMesh(test::outlineOf(loop), {elements, 4, elements, 4}, c.degree);
  }
  static contact::Conditions conditionsOf(const Case& c) {
    contact::Conditions conditions;
    const double length = c.length;
    conditions.contact["bottom"] = {
        [](Vec2 x) { return 0.1 * std::max(0.0, -x.y); },
        contact::makeFriction("Coulomb", {[c](Vec2) { return c.friction; }})};
    conditions.neumann["top"] = {
        [](Vec2) { return 0.0; },
        [length](Vec2 x) { return -0.01 * (1 + 0.5 * std::sin(7 * x.x / length)); }};
    conditions.neumann["left"] = {[](Vec2) { return 0.002; }, [](Vec2) { return 0.0; }};
    return conditions;
  }
};

/// C u of closed and sticking coefficients over length and displacement: what is to vanish.
double open(const contact::ContactSystem& system, const contact::Configuration& at) {
  const contact::Problem& problem = system.numbers();
  const Vector& r = at.penetration;
  const Vector lengths = system.multiplier().lengths();
  const auto states =
      contact::Equation(problem, contact::Equation::Bound::Differentiated, 0)
          .at(pack(problem, at.state))
          .states;
  double most = 0;
  for (std::size_t i = 0; i < r.size(); ++i)
    if (states[i] == contact::ContactState::Closed ||
        states[i] == contact::ContactState::Stick)
      most = std::max(most, std::abs(r[i]) / lengths[i]);
  return most / largest(at.displacements.front());
}

TEUCHOS_UNIT_TEST(DefectCorrection, displacementsSayWhatTheFlexibilitySays) {
  const char* legendre = "Gauss-Legendre-Lagrange";
  for (const Case& c : {Case{2, Form::None, "Biorthogonal", 1},
                        {2, Form::None, "Biorthogonal", 3},
                        {2, Form::None, "Biorthogonal", 2, 0.1},
                        {2, Form::Exact, legendre, 2},
                        {2, Form::Projected, legendre, 2},
                        {2, Form::Projected, "Bernstein", 2, 0.1},
                        {2, Form::Density, legendre, 1},
                        {2, Form::Density, legendre, 3, 0.1}}) {
    const Body body(c);
    const auto agree = [&](const bem::SteklovPoincare& stiffness, double tolerance) {
      const contact::ContactSystem system = body.system(stiffness);
      const contact::Solution solution = test::solve(system.numbers());
      TEST_ASSERT(solution.report.converged());
      const Vector r = contact::penetration(system.numbers(), solution.state);
      const Vector byDisplacement = system.configuration(solution.state).penetration;
      TEST_COMPARE(test::largestDifference(r, byDisplacement), <, tolerance * largest(r));
    };
    agree(body.dense(), 1e-11);
    if (c.form == Form::None || c.form == Form::Density)
      agree(body.compressed(), 1e-8);
  }
}

TEUCHOS_UNIT_TEST(DefectCorrection, slenderBodiesLieWhereContactHoldsThem) {
  const Body body({100, Form::None, "Biorthogonal", 1});
  const bem::SteklovPoincare dense = body.dense();
  const bem::SteklovPoincare compressed = body.compressed();
  const contact::ContactSystem exact = body.system(dense);
  const contact::ContactSystem own = body.system(compressed);
  const auto solved = [](const contact::ContactSystem& system) {
    return test::solve(system.numbers()).state;
  };
  const contact::State first = solved(own);
  const contact::Configuration before = own.configuration(first);
  const contact::Configuration after = corrected(own, first, test::processes());
  const contact::Configuration reference =
      corrected(exact, solved(exact), bem::oneProcess());
  const auto off = [&](const contact::Configuration& at) {
    const Vector& u = reference.displacements.front();
    return test::largestDifference(at.displacements.front(), u) / largest(u);
  };
  out << "open " << open(own, before) << ", " << open(own, after) << ", dense "
      << open(exact, reference) << "; off " << off(before) << ", " << off(after) << "\n";
  TEST_COMPARE(open(own, before), >, 1e-6);
  TEST_COMPARE(open(own, after), <, 5e-8);
  TEST_COMPARE(open(exact, reference), <, 1e-10);
  TEST_COMPARE(off(before), >, 1e-6);
  TEST_COMPARE(off(after), <, 5e-8);
}

/// What has its shear at the bound slips there, a little near the ends of what sticks: less than
/// D rounds by.
TEUCHOS_UNIT_TEST(DefectCorrection, placesThatSlipALittleAreSaidToSlip) {
  const Body body({200, Form::None, "Biorthogonal", 1, 0, 0.007});
  const bem::SteklovPoincare compressed = body.compressed();
  const contact::ContactSystem system = body.system(compressed);
  const contact::Problem& problem = system.numbers();
  const contact::Configuration at =
      corrected(system, test::solve(problem).state, test::processes());
  const Vector bounds = problem.slipBounds(at.state.multiplier);
  const auto atBoundButStuck = [&](const contact::ContactStates& states) {
    int count = 0;
    for (std::size_t t = 0; t < bounds.size(); ++t)
      count +=
          states[problem.normals + t] == contact::ContactState::Stick &&
          std::abs(at.state.multiplier[problem.normals + t]) >= (1 - 1e-9) * bounds[t];
    return count;
  };
  const auto slips = [&](const contact::ContactStates& states) {
    return std::count(states.begin(), states.end(), contact::ContactState::SlipForward);
  };
  const auto states = contact::classify(problem, at.state, at.penetration);
  TEST_EQUALITY(atBoundButStuck(states), 0);
  TEST_COMPARE(slips(states), >, 100);
  const Vector byD = contact::penetration(problem, at.state);
  double rounding = 0;
  double smallest = 1;
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    const std::size_t i = problem.normals + t;
    rounding = std::max(rounding, std::abs(byD[i] - at.penetration[i]));
    if (states[i] == contact::ContactState::SlipForward)
      smallest = std::min(smallest, std::abs(at.penetration[i]));
  }
  TEST_COMPARE(smallest, <, rounding);

  contact::PathMemory memory(system);
  memory.add(system, at);
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    const std::size_t i = problem.normals + t;
    const double work = at.state.multiplier[i] * at.penetration[i];
    const bool sticks = states[i] == contact::ContactState::Stick;
    TEST_EQUALITY(memory.frictionWork()[t], sticks ? 0 : work);
    TEST_ASSERT(sticks || work > 0);
  }
}

/// What stands still costs no step of Newton's, although r by D and by displacements differ: its
/// residual is that of rounding, however much of r the step before left.
TEUCHOS_UNIT_TEST(DefectCorrection, heldLoadsAreSolvedByTheStepBefore) {
  const Body body({60, Form::None, "Biorthogonal", 1});
  const bem::SteklovPoincare compressed = body.compressed();
  const contact::ContactSystem first = body.system(compressed);
  const std::vector<contact::Conditions> same = {body.conditions};
  contact::PathMemory memory(first);
  contact::State state;
  for (int step = 0; step < 4; ++step) {
    const contact::ContactSystem now = first.under(same, {}, memory.forStep());
    const contact::Solution solution = test::solve(now.numbers(), state);
    TEST_ASSERT(solution.report.converged());
    if (step > 0) {
      TEST_EQUALITY(solution.report.newtonIterations, 0);
      TEST_COMPARE(solution.report.residual, <, 1e-14);
    }
    contact::Configuration at = corrected(now, solution.state, test::processes());
    const auto states = contact::classify(now.numbers(), at.state, at.penetration);
    for (std::size_t i = 0; i < states.size(); ++i)
      if (states[i] == contact::ContactState::Closed)
        at.penetration[i] += 1e-9 * now.multiplier().lengths()[i];
    memory.add(now, at);
    state = at.state;
  }
}

}  // namespace

}  // namespace epafi
