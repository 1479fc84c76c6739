// A block pressed on a rough floor, solved by what the lists of a file assemble.
//
//   assemble     prints the lists with all defaults, the stages of the solve and the friction

#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/CoulombIteration.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Teuchos_RCPStdSharedPtrConversions.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>

namespace {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using bem::Vec2;
using Teuchos::sublist;

/// A unit square, pressed onto the floor and pushed along it at its top.
contact::Conditions pushed() {
  contact::Conditions conditions;
  conditions.contact["floor"] = {
      [](Vec2) { return 0.0; },
      contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }})};
  conditions.dirichlet["top"] = {[](Vec2) { return 0.01; }, [](Vec2) { return -0.05; }};
  return conditions;
}

contact::ContactSystem makeSystem(const contact::Stabilization& stabilization) {
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"floor", "right", "top", "left"}};
  const bem::Mesh mesh =
      bem::makeMesh(std::make_shared<const bem::Outline>(square), {16, 8, 16, 8}, 2);
  const bem::Material material{5, 0.3, false};
  const bem::Lame lame{material};
  const contact::Conditions conditions = pushed();
  const bem::Space space = contact::makeSpace(mesh, conditions, stabilization);
  const bem::Units units{mesh.outline().diameter(), material.youngsModulus};
  const bem::SteklovPoincare stiffness =
      contact::makeStiffness(space, conditions, stabilization, lame, units);
  return contact::ContactSystem(
      {{space, stiffness, lame, units, conditions,
        contact::multiplierBasis("Gauss-Legendre-Lagrange"), stabilization}});
}

double shear(const contact::Problem& problem, const contact::State& state) {
  double largest = 0;
  for (auto i = static_cast<std::size_t>(problem.normals); i < state.multiplier.size();
       ++i)
    largest = std::max(largest, std::abs(state.multiplier[i]));
  return largest;
}

int run() {
  const auto list = Teuchos::getParametersFromXmlFile(SOLVER);

  const contact::NoxNewton newton(Teuchos::get_shared_ptr(sublist(list, "NOX")));
  contact::ContactSolver tresca(newton);
  tresca.setParameterList(sublist(list, "Tresca"));
  const auto coulomb = contact::coulombFromList(tresca, sublist(list, "Coulomb"));

  const contact::ContactSystem system = makeSystem({});
  const contact::Problem& problem = system.numbers();
  const contact::Solution solution = coulomb->solve(problem, {});

  std::cout << *list << told(solution.report.stages) << "\nlargest shear "
            << shear(problem, solution.state) << "\n";

  // the same by the parts as they are
  const contact::ContactSolver other(newton);
  const contact::Solution direct = contact::makeCoulomb(other, {})->solve(problem, {});
  double difference = 0;
  for (std::size_t i = 0; i < direct.state.multiplier.size(); ++i)
    difference = std::max(
        difference, std::abs(direct.state.multiplier[i] - solution.state.multiplier[i]));
  return solution.report.converged() && difference < 1e-9 * problem.stress ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "assemble: %s\n", error.what());
    return 1;
  }
}
