// A block on a rough floor, driven step by step by an application of its own: an actuator pushes its
// top to and fro and is controlled by the force that friction gives back.
//
//   drive        prints t, where the actuator is, its force and friction's work so far

#include "contact/nox/ContactModel.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/path/Prediction.hpp"
#include "contact/solve/CoulombIteration.hpp"
#include "contact/solve/Settled.hpp"

#include <Thyra_VectorStdOps.hpp>

#include <cmath>
#include <cstdio>

namespace {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using bem::Vec2;
using contact::ContactModel;

constexpr double limit = 0.02;  // of the actuator's force

/// A unit square, clamped to the actuator at its top.
bem::Mesh mesh() {
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"floor", "right", "actuator", "left"}};
  return bem::makeMesh(std::make_shared<const bem::Outline>(square), {24, 8, 24, 8}, 2);
}

/// Everything that depends on the time is a value: the conditions of a step.
std::vector<contact::Conditions> pushed(double along) {
  contact::Conditions conditions;
  conditions.contact["floor"] = {
      [](Vec2 x) { return 0.01 * x.x * (1 - x.x); },
      contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }})};
  conditions.dirichlet["actuator"] = {[along](Vec2) { return along; },
                                      [](Vec2) { return -0.05; }};
  return {conditions};
}

/// The force on the top along it, in the user's units.
double forceOf(const contact::ContactSystem& step, const contact::Configuration& at,
               bem::Units units) {
  return units.stress * units.length *
         step.body(0).clampWork(at.results[0].clampForces).front();
}

contact::Solution solved(const contact::Problem& problem, const contact::State& start) {
  const contact::NoxNewton newton;
  const contact::ContactSolver solver(newton);
  return contact::makeCoulomb(solver, {})->solve(problem, start);
}

/// Does the state solve this part of the step?  |f| of the model, relative to the load.
double residual(const ContactModel& model, const contact::State& state, double part) {
  auto in = model.createInArgs();
  auto out = model.createOutArgs();
  in.set_x(model.point(state));
  const auto increment = Thyra::createMember(*model.get_p_space(ContactModel::Increment));
  Thyra::assign(increment.ptr(), part);
  in.set_p(ContactModel::Increment, increment);
  const auto f = Thyra::createMember(*model.get_f_space());
  out.set_f(f);
  model.evalModel(in, out);
  return Thyra::norm_inf(*f);
}

int run() {
  const bem::Material steelLike{5, 0.3, false};
  const bem::Lame lame{steelLike};
  const contact::Stabilization stabilization;
  const auto& basis = contact::multiplierBasis("Gauss-Legendre-Lagrange");
  const std::vector<contact::Conditions> start = pushed(0);
  const bem::Space space = contact::makeSpace(mesh(), start[0], stabilization);
  const bem::Units units{space.mesh().outline().diameter(), steelLike.youngsModulus};
  const bem::SteklovPoincare stiffness =
      contact::makeStiffness(space, start[0], stabilization, lame, units);
  // operators, factors and D: once
  const contact::ContactSystem system(
      {{space, stiffness, lame, units, start[0], basis, stabilization}});

  contact::PathMemory memory(system);
  contact::Prediction prediction(system);
  std::vector<contact::Conditions> before = start;
  double along = 0;
  double velocity = 0.004;
  double work = 0;
  int turns = 0;
  bool good = true;
  std::printf("# step, actuator, force, friction's work\n");
  for (int k = 1; turns < 4 && k < 400; ++k) {
    const std::vector<contact::Conditions> now = pushed(along);
    contact::ContactSystem step = system.under(now, {}, memory.forStep());
    // the step as a function of the state and of how much of it is done
    const contact::ContactSystem last = system.under(before, {}, memory.forStep());
    const ContactModel model(
        contact::ProblemFamily(step.numbers(), step.gap(), last.numbers()),
        ContactModel::Options());
    if (k > 1)
      good = good && residual(model, prediction.last(), 0) < 1e-9;
    const auto solve = [&](const contact::State* from) {
      return solved(step.numbers(), from != nullptr ? *from : prediction.start(step));
    };
    const contact::Settled settled = contact::settled(step, solve, bem::oneProcess());
    const contact::Configuration& at = settled.at;
    good = good && settled.solution.report.converged() &&
           residual(model, settled.solution.state, 1) < 1e-9;
    memory.add(step, at);
    prediction.add(step, at.state);
    good = good && memory.friction() >= work;
    work = memory.friction();
    const double force = forceOf(step, at, units);
    std::printf("%3d %9.6f %10.7f %.8e\n", k, along, force,
                units.stress * units.length * units.length * work);
    // turn back where the force is too large: what comes next depends on what comes out
    if (force * velocity > 0 && std::abs(force) > limit) {
      velocity = -velocity;
      ++turns;
    }
    along += velocity;
    before = now;
  }
  good = good && turns == 4 && work > 0;
  if (!good)
    std::fprintf(stderr, "drive: the results are wrong\n");
  return good ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "drive: %s\n", error.what());
    return 1;
  }
}
