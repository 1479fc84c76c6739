// Contact on circular arcs: normals turn along an element, sides close, and a rotation is no
// polynomial.  On any number of ranks.
#include "bem/space/DisplacementField.hpp"
#include "contact/Form.hpp"
#include "contact/SolvedScene.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::Vec2;

constexpr double radius = 2;

/// The first arc starts at the right.
bem::Loop disc(const std::vector<std::string>& names) {
  bem::Loop loop = reference::disc(static_cast<int>(names.size()), radius);
  loop.edges = names;
  return loop;
}

test::SolvedScene solvedDisc(const std::vector<std::string>& names, int elementsPerEdge,
                             int degree, const contact::Conditions& conditions,
                             const std::string& basis,
                             contact::Stabilization::Form form) {
  return test::SolvedScene(
      {bem::makeMesh(reference::outlineOf(disc(names)),
                     std::vector<int>(names.size(), elementsPerEdge), degree),
       bem::Material{1, 0.3, false}, conditions, basis, test::ofForm(form)});
}

double zero(Vec2) { return 0; }

double imbalance(const contact::Summary& s) {
  return std::max({std::abs(s.load.x + s.contact.x + s.reaction.x),
                   std::abs(s.load.y + s.contact.y + s.reaction.y),
                   std::abs(s.load.moment + s.contact.moment + s.reaction.moment)});
}

using Form = contact::Stabilization::Form;

/// An uneven push from the upper left.
contact::Conditions pushed() {
  contact::Conditions conditions;
  conditions.neumann["load"] = {[](Vec2 x) { return 1 + x.x; },
                                [](Vec2 x) { return -3 - x.y * x.x; }};
  return conditions;
}

}  // namespace

// Degree 1, where the interpolated rotation is off by 1 % and more.
TEUCHOS_UNIT_TEST(Disc, balancesWhateverHoldsIt) {
  for (const Form form : {Form::Projected, Form::Exact, Form::Density, Form::None})
    for (const int degree : {1, 3}) {
      contact::Conditions resting = pushed();
      resting.contact["floor"] = {[](Vec2) { return 0.0; }, nullptr, {}};
      resting.fix = {true, false, true};
      const auto fixed = solvedDisc({"free", "load", "free", "floor", "floor"}, 3, degree,
                                    resting, "Gauss-Legendre-Lagrange", form);
      TEST_COMPARE(imbalance(summarize(fixed.solved())), <, 1e-12);
      TEST_COMPARE(std::abs(summarize(fixed.solved()).contact.y), >, 1);

      contact::Conditions clamped = pushed();
      clamped.dirichlet["clamp"] = {zero, zero};
      clamped.contact["floor"] = {[](Vec2) { return 0.001; }, nullptr, {}};
      const auto held = solvedDisc({"free", "load", "clamp", "floor", "free"}, 3, degree,
                                   clamped, "Gauss-Legendre-Lagrange", form);
      TEST_COMPARE(imbalance(summarize(held.solved())), <, 1e-12);
    }
}

// In a ring that is too narrow by δ:  λ_n = 2 μ δ / ((1-2ν) R) all around.
TEUCHOS_UNIT_TEST(Disc, isPressedEvenlyAllAround) {
  const double delta = 1e-3;
  contact::Conditions ring;
  ring.contact["all"] = {[=](Vec2) { return -delta; }, nullptr, {}};
  ring.fix = {true, true, true};
  const bem::Lame lame(bem::Material{1, 0.3, false});
  const double pressure = 2 * lame.mu * delta / ((1 - 2 * 0.3) * radius);
  for (const char* basis :
       {"Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal"})
    for (const Form form : {Form::Projected, Form::Density, Form::None}) {
      if (form != Form::None && contact::multiplierBasis(basis).sharesNodes)
        continue;
      const auto all = solvedDisc({"all", "all"}, 3, 8, ring, basis, form);
      TEST_ASSERT(all.report().converged());
      const contact::MultiplierSpace& space = all.solved().problem.multiplier();
      double worst = 0;
      for (const auto& element : space.elements())
        for (const double t : {-1.0, -0.4, 0.7, 1.0})
          worst = std::max(
              worst, std::abs(space.at(all.solved().state.multiplier, element, t).normal -
                              pressure));
      out << basis << ": ";
      TEST_COMPARE(worst, <, 1e-6 * pressure);
    }
}

// One-valued across every smooth joint, the closing one too.
TEUCHOS_UNIT_TEST(Disc, sharesAllNodesOfAClosedSide) {
  contact::Conditions ring;
  ring.contact["all"] = {[](Vec2) { return 0.0; }, nullptr, {}};
  const auto outline = reference::outlineOf(disc({"all", "all", "all"}));
  for (const int degree : {1, 2, 5}) {
    const bem::Mesh mesh = bem::makeMesh(outline, {2, 2, 2}, degree);
    const contact::MultiplierSpace space(mesh, contact::multiplierBasis("Biorthogonal"),
                                         ring);
    TEST_EQUALITY(space.size(), 6 * degree);
    const auto& elements = space.elements();
    for (std::size_t k = 0; k < elements.size(); ++k)
      TEST_EQUALITY(elements[k].normalOf(degree),
                    elements[(k + 1) % elements.size()].normalOf(0));
  }
}

// A body that turns freely about its contact: the rotation costs nothing at degree 1.
TEUCHOS_UNIT_TEST(Disc, turnsWithoutStrain) {
  contact::Conditions turned;
  const double angle = 1e-2;
  turned.dirichlet["all"] = {[=](Vec2 x) { return -angle * x.y; },
                             [=](Vec2 x) { return angle * x.x; }};
  const auto rigid = solvedDisc({"all", "all", "all"}, 2, 1, turned,
                                "Gauss-Legendre-Lagrange", Form::None);
  const contact::Solved solved = rigid.solved();
  TEST_COMPARE(std::abs(summarize(solved).energyStrain), <, 1e-15 * angle * angle);
  const Vec2 u = bem::DisplacementField(solved.space, solved.displacement).at(1, 0.3);
  const Vec2 x = solved.space.mesh().physicalPoint(1, 0.3);
  TEST_COMPARE(norm(solved.units.length * u - angle * turnLeft(x)), <, 1e-15);
}

}  // namespace epafi
