// What Fix holds, condensed with the displacements of a body: all forms of the stabilisation.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using bem::at;
using bem::Index;
using bem::Vec2;
using bem::Vector;
using Form = contact::Stabilization::Form;

constexpr Form forms[] = {Form::Density, Form::Projected, Form::Exact};

/// With arcs above and at the bottom, or straight.
bem::Mesh blockMesh(bool bent, int degree) {
  bem::Loop loop = test::rectangle({-0.3, 0.1}, 0.7, 0.5);
  if (bent)
    loop.bulges = {0.2, 0, 0.3, 0};
  return bem::makeMesh(test::outlineOf(loop), {3, 2, 2, 2}, degree);
}

contact::Conditions conditionsOn(const std::vector<const char*>& sides,
                                 const contact::Conditions::Fix& fix) {
  contact::Conditions conditions;
  conditions.fix = fix;
  for (const char* side : sides)
    conditions.contact[side] = {
        [](Vec2) { return 0.0; },
        contact::makeFriction("Tresca", {[](Vec2) { return 1.0; }})};
  return conditions;
}

struct Case {
  bool bent;
  int degree;
  contact::Conditions::Fix fix;
  bool isGuided;  ///< does a clamp hold it across x?
};

/// r of displacements is that of D, also beside free motions and clamps, and the energy stored
/// without loads ½ λᵀ D λ: what Fix holds does no work.
TEUCHOS_UNIT_TEST(Reactions, areThoseOfTheDisplacements) {
  const Case cases[] = {
      {false, 1, {true, true, true}, false},
      {true, 2, {true, true, true}, false},
      {true, 3, {true, false, true}, false},
      {false, 2, {false, true, false}, true},
  };
  for (const Case& c : cases)
    for (const Form form : forms) {
      contact::Conditions conditions = conditionsOn({"bottom", "right"}, c.fix);
      if (c.isGuided)
        conditions.dirichlet["left"] = {[](Vec2) { return 0.0; }, {}};
      const test::BodyScene scene({blockMesh(c.bent, c.degree),
                                   {1, 0.3, false},
                                   conditions,
                                   "Gauss-Legendre-Lagrange",
                                   test::ofForm(form)});
      const bem::SteklovPoincare stiffness = scene.dense();
      const contact::ContactSystem system({scene.input(stiffness)});
      const contact::Problem& numbers = system.numbers();
      contact::State state;
      for (Index i = 0; i < numbers.size(); ++i)
        state.multiplier.push_back(0.1 + std::sin(1.0 + 3.0 * static_cast<double>(i)));
      if (numbers.rigidMotions() > 0)
        state.rigid.assign(at(numbers.rigidMotions()), 0.3);
      const contact::Configuration there = system.configuration(state);
      const Vector& reactions = system.body(0).fixedReactions(there.contactForces[0]);
      TEST_COMPARE(test::largest(reactions), >, 0.01);
      const Vector r = contact::penetration(numbers, state);
      TEST_COMPARE(test::largestDifference(there.penetration, r), <,
                   1e-12 * test::largest(r));
      if (numbers.rigidMotions() > 0)
        continue;
      const Vector image = numbers.flexibility.times(state.multiplier);
      TEST_FLOATING_EQUALITY(2 * there.storedEnergy(), bem::dot(state.multiplier, image),
                             1e-11);
    }
}

/// Tractions r on all of the boundary are those that Fix holds: nothing moves, nothing opens,
/// however large γ is.
TEUCHOS_UNIT_TEST(Reactions, takeTractionsOfRigidMotionsAway) {
  for (const Form form : forms)
    for (int mode = 0; mode < 3; ++mode) {
      contact::Stabilization stabilization = test::ofForm(form);
      if (form == Form::Density)
        stabilization.gamma0 = 1e3;
      const test::BodyScene scene(
          {blockMesh(false, 2),
           {1, 0.3, false},
           conditionsOn({"bottom", "right", "top", "left"}, {true, true, true}),
           "Gauss-Legendre-Lagrange",
           stabilization});
      const bem::SteklovPoincare stiffness = scene.dense();
      const contact::ContactSystem system({scene.input(stiffness)});
      const contact::RigidModes& modes = system.body(0).holding().modes;
      const bem::Mesh& mesh = scene.space.mesh();
      contact::State state;
      state.multiplier.resize(at(system.numbers().size()));
      for (const auto& element : scene.multiplier.elements(0)) {
        const Vector places = scene.basis.places(element.degree);
        for (int i = 0; i <= element.degree; ++i) {
          const Vec2 r = modes.at(mode, mesh.scaledPoint(element.element, places[at(i)]));
          const Vec2 normal = mesh[element.element].curve.normal(0);
          state.multiplier[at(element.normalOf(i))] = dot(r, normal);
          state.multiplier[at(element.tangentialOf(i))] = dot(r, turnLeft(normal));
        }
      }
      const contact::Configuration there = system.configuration(state);
      Vector reactions = system.body(0).fixedReactions(there.contactForces[0]);
      reactions[at(mode)] -= 1;
      TEST_COMPARE(test::largest(reactions), <, 1e-12);
      const Vector& u = there.displacements.front();
      TEST_COMPARE(test::largest(u), <, 1e-12);
      TEST_COMPARE(test::largest(contact::penetration(system.numbers(), state)), <,
                   1e-12);
      TEST_COMPARE(test::largest(there.penetration), <, 1e-12);
    }
}

}  // namespace

}  // namespace epafi
