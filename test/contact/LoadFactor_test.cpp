#include "Largest.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/ProblemFamily.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace {

namespace bem = epafi::bem;
namespace contact = epafi::contact;
using bem::Vec2;
using contact::Index;
using contact::Vector;
using epafi::test::largest;
using epafi::test::largestDifference;
using epafi::test::solve;

// A block over a curved foundation, its top pulled, pushed and displaced by `load`; with
// or without a clamp.
contact::Conditions conditionsFor(double load, bool clamped) {
  contact::Conditions conditions;
  conditions.contact["bottom"] = {
      [](Vec2 x) { return 0.01 + 0.05 * x.x * x.x; },
      contact::makeFriction("Coulomb", {[](Vec2) { return 0.4; }})};
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

struct Scene {
  explicit Scene(double load, bool clamped)
      : conditions(conditionsFor(load, clamped)),
        space(contact::makeSpace(bem::makeMesh(outline(), {4, 2, 3, 2}, 2), conditions,
                                 {})),
        stiffness(contact::makeStiffness(
            space, contact::MultiplierSpace(space.mesh(), basis, conditions), {}, lame,
            units)),
        system({{space, stiffness, lame, units, conditions, basis, {}}}) {}

  static std::shared_ptr<const bem::Outline> outline() {
    return std::make_shared<bem::Outline>(bem::Loop{{{-1, 0}, {1, 0}, {1, 1}, {-1, 1}},
                                                    {"bottom", "right", "top", "left"}});
  }

  bem::Lame lame{bem::Material{5, 0.3, false}};
  bem::Units units{outline()->diameter(), 5};
  const contact::MultiplierBasis& basis =
      contact::multiplierBasis("Gauss-Legendre-Lagrange");
  contact::Conditions conditions;
  bem::Space space;
  bem::SteklovPoincare stiffness;
  contact::ContactSystem system;
};

/// Twice the load factor is twice all tractions and prescribed displacements over the
/// same gap.
TEUCHOS_UNIT_TEST(LoadFactor, scalesTractionsAndPrescribedDisplacements) {
  for (const bool clamped : {false, true}) {
    const Scene one(1, clamped);
    const Scene two(2, clamped);
    const contact::ProblemFamily family(one.system.numbers(), one.system.gap());
    const contact::Problem scaled = family.at({2, 1});
    const contact::Problem& expected = two.system.numbers();
    TEST_COMPARE(largestDifference(scaled.offset, expected.offset), <,
                 1e-14 * largest(expected.offset) * 10);
    TEST_COMPARE(largestDifference(scaled.rigidLoad, expected.rigidLoad), <, 1e-14);
    TEST_COMPARE(largest(one.system.gap()), >, 1e-4);
  }
}

/// What doc/howto/embed.md says of the displacement at another load factor.
TEUCHOS_UNIT_TEST(LoadFactor, displacementAddsTheRestOfTheLoad) {
  for (const bool clamped : {false, true}) {
    const Scene one(1, clamped);
    const Scene two(2, clamped);
    const contact::State state = solve(two.system.numbers(), {}, {}).state;
    Vector u = one.system.body(0).displacement(state);
    const Vector rest = one.system.body(0).displacement({});
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += rest[i];
    const Vector expected = two.system.body(0).displacement(state);
    TEST_COMPARE(largestDifference(u, expected), <, 1e-12 * largest(expected));
  }
}

}  // namespace
