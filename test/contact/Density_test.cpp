// Stabilisation by the density: what ContactSystem condenses is the saddle point of
//   1/2 <W u,u> + <ψ,(K+1/2) u> - 1/2 <V ψ,ψ> + <λ,u> - <Σ ρ r,u> - 1/2 Σ γ |λ + ψ - Σ ρ r|²,
// whose equations are asked for here, with forms integrated anew.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/system/ContactSystem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::at;
using bem::Index;
using bem::Vec2;
using bem::Vector;
using contact::Stabilization;

/// A square of diameter one whose bottom touches, and its right side if asked for.
bem::Mesh squareMesh(const std::vector<int>& elements, int degree) {
  const double side = std::sqrt(0.5);
  return bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, side, side)), elements,
                       degree);
}

contact::Conditions conditionsOf(const char* law, bool isFixed) {
  contact::Conditions conditions;
  if (isFixed)
    conditions.fix = {true, true, true};
  else
    conditions.dirichlet["left"] = {[](Vec2) { return 0.0; }, [](Vec2) { return 0.0; }};
  conditions.neumann["top"] = {[](Vec2) { return 0.01; },
                               [](Vec2 x) { return -0.1 * (1 + x.x); }};
  std::vector<bem::Function> fields;
  if (law != std::string("None"))
    fields = {[](Vec2) { return 0.3; }};
  for (const char* side : {"bottom", "right"})
    conditions.contact[side] = {[](Vec2 x) { return 0.01 * x.x; },
                                contact::makeFriction(law, fields)};
  return conditions;
}

struct Case {
  std::vector<int> elements;
  int degree;
  const char* basis;
  const char* law;
  bool raised;
  double nu;
  double gamma0;
  bool isFixed = false;
};

Stabilization stabilizationOf(const Case& c) {
  Stabilization stabilization = test::ofForm(Stabilization::Form::Density);
  stabilization.gamma0 = c.gamma0;
  stabilization.raised = c.raised;
  return stabilization;
}

contact::State stateOf(Index size) {
  contact::State state;
  for (Index i = 0; i < size; ++i)
    state.multiplier.push_back(0.05 + 0.1 * std::sin(1.0 + 3.0 * static_cast<double>(i)));
  return state;
}

Vector unit(Index k, Index of) {
  Vector vector(at(of));
  vector[at(k)] = 1;
  return vector;
}

/// What a point of a side in contact gives to the equations.
struct Point {
  const contact::MultiplierSpace::ContactElement& element;
  double t, weight, gamma;
};

/// γ = γ₀ h/p² with the smallest h of an element and its neighbours.
std::vector<Point> pointsOf(const Case& c, const bem::Mesh& mesh,
                            const contact::MultiplierSpace& multiplier) {
  const bem::Rule& rule = bem::gaussLegendre(c.degree + 4);
  std::vector<Point> points;
  for (const auto& element : multiplier.elements(0)) {
    const bem::Element& e = mesh[element.element];
    const double h = 2 * std::min({e.half, mesh[e.previous].half, mesh[e.next].half});
    for (int q = 0; q < rule.size(); ++q)
      points.push_back({element, rule.points[q], e.half * rule.weights[q],
                        c.gamma0 * h / (c.degree * c.degree)});
  }
  return points;
}

/// Adds <stress, φ> of a point to the equations of displacements.
void addWork(const bem::Space& space, int e, double t, Vec2 stress, Vector& forces) {
  for (int k = 0; k <= space.mesh()[e].degree; ++k)
    for (int d = 0; d < 2; ++d) {
      const Index row = space.displacement(e, k, d);
      const Vector phi = unit(row, space.displacements());
      forces[at(row)] += dot(bem::DisplacementField(space, phi).at(e, t), stress);
    }
}

/// The equations of the saddle point
///   W u + K' ψ + <λ - Σ ρ r, φ> - f = 0 of what is not held,   K u - V ψ - <γ (λ + ψ - Σ ρ r), P> = 0,
///   <u, r> - <γ (λ + ψ - Σ ρ r), r> = 0 of what Fix holds
/// and what is left of the contact's, r = <χ, u - γ (λ + ψ - Σ ρ r)> - <χ, g>.
TEUCHOS_UNIT_TEST(Density, theCondensedProblemIsTheSaddlePoint) {
  const Case cases[] = {
      {{3, 2, 3, 2}, 1, "Gauss-Legendre-Lagrange", "Coulomb", false, 0.3, 0.5},
      {{2, 2, 3, 2}, 3, "Gauss-Lobatto-Lagrange", "Tresca", false, 0.3, 0.5},
      {{2, 3, 2, 2}, 2, "Bernstein", "None", false, 0.3, 1e4},
      {{2, 3, 2, 2}, 2, "Bernstein", "Coulomb", false, -0.5, 1e-6},
      {{3, 2, 3, 2}, 2, "Gauss-Legendre-Lagrange", "Coulomb", false, 0.5, 0.5},
      {{9, 4, 6, 5}, 1, "Gauss-Legendre-Lagrange", "Coulomb", true, 0.3, 0.5},
      {{2, 9, 3, 2}, 3, "Gauss-Lobatto-Lagrange", "Tresca", true, 0.5, 0.5},
      {{3, 2, 3, 2}, 1, "Gauss-Legendre-Lagrange", "Coulomb", true, 0.3, 0.5, true},
      {{2, 2, 3, 2}, 3, "Gauss-Lobatto-Lagrange", "None", false, 0.3, 1e3, true},
      {{9, 4, 6, 5}, 2, "Bernstein", "Tresca", true, 0.5, 0.1, true},
  };
  for (const Case& c : cases) {
    const test::BodyScene scene({squareMesh(c.elements, c.degree),
                                 {1, c.nu, false},
                                 conditionsOf(c.law, c.isFixed),
                                 c.basis,
                                 stabilizationOf(c)});
    const bem::Space& space = scene.space;
    const bem::Mesh& mesh = space.mesh();
    const bem::SteklovPoincare stiffness = scene.dense();
    const contact::ContactSystem system({scene.input(stiffness)});
    const contact::Problem& numbers = system.numbers();
    const contact::ContactBody& body = system.body(0);
    const contact::State state = stateOf(numbers.size());
    const Vector u = body.displacement(state);
    const Vector density = body.density(state, u, body.contactForce(state.multiplier));

    const bem::Operators operators = bem::assembleOperators(space, scene.lame);
    Vector forces = bem::multiplySymmetric(operators.hypersingular, u);
    Vector gaps = bem::multiplySymmetric(operators.singleLayer, density);
    const double energy = 0.5 * (bem::dot(forces, u) + bem::dot(gaps, density));
    TEST_FLOATING_EQUALITY(
        body.results(state, u, body.contactForce(state.multiplier)).strainEnergy, energy,
        1e-10);
    const Vector ku = bem::product(operators.doubleLayer, u);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      gaps[i] = ku[i] - gaps[i];
      for (std::size_t j = 0; j < forces.size(); ++j)
        forces[j] += operators.doubleLayer(static_cast<Index>(i), static_cast<Index>(j)) *
                     density[i];
    }

    const bem::Vec2 centroid = body.holding().modes.centroid;
    const Vector rho = body.fixedReactions(body.contactForce(state.multiplier));
    const auto reactionAt = [&](int e, double t) {
      return Vec2{rho[0], rho[1]} + rho[2] * turnLeft(mesh.scaledPoint(e, t) - centroid);
    };
    Vec2 means;  // of what Fix holds
    double turn = 0;
    const auto addMean = [&](int e, double t, Vec2 mean) {
      means = means + mean;
      turn += cross(mesh.scaledPoint(e, t) - centroid, mean);
    };

    Vector residual = bem::product(numbers.flexibility.entries(), state.multiplier);
    bem::axpy(-1, numbers.offset, residual);  // -r, and then r by the fields
    const bem::DisplacementField displacement(space, u);
    for (const Point& point : pointsOf(c, mesh, scene.multiplier)) {
      const int e = point.element.element;
      const Vec2 normal = mesh[e].segment().normal;
      const auto stressOf = [&](const Vector& lambda) {
        const auto value = scene.multiplier.at(lambda, point.element, point.t);
        return value.normal * normal + value.tangential * turnLeft(normal);
      };
      const Vec2 stress = stressOf(state.multiplier);
      addWork(space, e, point.t, point.weight * stress, forces);
      const Vec2 slack = point.gamma * (stress + space.densityAt(density, e, point.t) -
                                        reactionAt(e, point.t));
      addMean(e, point.t, -point.weight * slack);
      for (int i = 0; i < mesh[e].densities; ++i)
        for (int d = 0; d < 2; ++d) {
          const Index row = space.density(e, i, d);
          const Vec2 p = space.densityAt(unit(row, space.densities()), e, point.t);
          gaps[at(row)] -= point.weight * dot(p, slack);
        }
      const double gap = 0.01 * mesh.physicalPoint(e, point.t).x;
      for (Index i = 0; i < numbers.size(); ++i)
        residual[at(i)] +=
            point.weight * dot(stressOf(unit(i, numbers.size())),
                               displacement.at(e, point.t) - slack - gap * normal);
    }
    const bem::Rule& rule = bem::gaussLegendre(c.degree + 4);
    for (const int e : mesh.elementsOf("top"))
      for (int q = 0; q < rule.size(); ++q) {
        const double x = mesh.physicalPoint(e, rule.points[q]).x;
        addWork(space, e, rule.points[q],
                -mesh[e].half * rule.weights[q] * Vec2{0.01, -0.1 * (1 + x)}, forces);
      }
    for (int e = 0; c.isFixed && e < mesh.size(); ++e)
      for (int q = 0; q < rule.size(); ++q) {
        const double t = rule.points[q];
        const double weight = mesh[e].half * rule.weights[q];
        addWork(space, e, t, -weight * reactionAt(e, t), forces);
        addMean(e, t, weight * displacement.at(e, t));
      }
    if (c.isFixed)
      TEST_COMPARE(norm(means) + std::abs(turn), <, 1e-12 * test::largest(u));
    for (const int e : mesh.elementsOf("left"))
      for (int k = 0; !c.isFixed && k <= c.degree; ++k)
        for (int d = 0; d < 2; ++d) {
          const Index row = space.displacement(e, k, d);
          TEST_EQUALITY(u[at(row)], 0);
          forces[at(row)] = 0;
        }
    out << c.basis << ", degree " << c.degree << ": " << test::largest(forces) << " "
        << test::largest(gaps) << " of " << test::largest(ku) << ", "
        << test::largest(residual) << " of " << test::largest(numbers.offset) << "\n";
    TEST_COMPARE(test::largest(forces), <, 1e-12 * test::largest(density));
    TEST_COMPARE(test::largest(gaps), <, 1e-11 * test::largest(ku));
    TEST_COMPARE(test::largest(residual), <, 1e-11 * test::largest(numbers.offset));
    // what a residual leaves open: 2^(q+1) - 1 of control points
    TEST_EQUALITY(numbers.amplification,
                  c.basis == std::string("Bernstein") ? std::exp2(c.degree + 1) - 1 : 1);
  }
}

}  // namespace

}  // namespace epafi
