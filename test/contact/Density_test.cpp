// Stabilisation by the density: what ContactSystem condenses is the saddle point of
//   1/2 <W u,u> + <ψ,(K+1/2) u> - 1/2 <V ψ,ψ> + <λ,u> - 1/2 Σ γ |λ + ψ|²,
// solved here as a whole, with forms integrated anew.
#include "Largest.hpp"
#include "Rectangle.hpp"
#include "bem/algebra/LuFactor.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/space/DisplacementField.hpp"
#include "contact/BodyScene.hpp"
#include "contact/Form.hpp"
#include "contact/results/Summary.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using bem::at;
using bem::Index;
using bem::Matrix;
using bem::Vec2;
using bem::Vector;
using contact::Stabilization;

/// A square of diameter one whose bottom touches, and its right side if asked for.
bem::Mesh squareMesh(const std::vector<int>& elements, int degree) {
  const double side = std::sqrt(0.5);
  return bem::makeMesh(test::outlineOf(test::rectangle({0, 0}, side, side)), elements,
                       degree);
}

contact::Conditions conditionsOf(const char* law) {
  contact::Conditions conditions;
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
};

struct Condensed {
  Vector displacement;
  Vector density;
  Vector residual;  ///< r = d₀ - D λ
  double energy = 0;
  double scale = 1;
  double amplification = 1;
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

Condensed condensed(const Case& c) {
  const test::BodyScene scene({squareMesh(c.elements, c.degree),
                               {1, c.nu, false},
                               conditionsOf(c.law),
                               c.basis,
                               stabilizationOf(c)});
  const bem::SteklovPoincare stiffness = scene.dense();
  const contact::ContactSystem system({scene.input(stiffness)});
  const contact::Problem& numbers = system.numbers();
  const contact::ContactBody& body = system.body(0);
  const contact::State state = stateOf(numbers.size());
  Condensed result;
  result.displacement = body.displacement(state);
  result.density = body.density(state, result.displacement);
  result.energy = body.strainEnergy(state, result.displacement);
  result.amplification = numbers.amplification;
  result.residual = numbers.offset;
  for (Index j = 0; j < numbers.size(); ++j)
    for (Index i = 0; i < numbers.size(); ++i)
      result.residual[i] -= numbers.flexibility(i, j) * state.multiplier[j];
  return result;
}

/// The same from the block system
///   [ W   K'     ] [u]   [ f - <λ, φ>  ]
///   [ K  -(V+G)  ] [ψ] = [ <γ λ, P>    ],   r = <χ, u - γ (λ + ψ)> - <χ, g>
Condensed whole(const Case& c) {
  const bem::Lame lame({1, c.nu, false});
  const contact::Conditions conditions = conditionsOf(c.law);
  const bem::Space space = contact::makeSpace(squareMesh(c.elements, c.degree),
                                              conditions, stabilizationOf(c));
  const bem::Mesh& mesh = space.mesh();
  const contact::MultiplierSpace multiplier(mesh, contact::multiplierBasis(c.basis),
                                            conditions);
  const bem::Operators operators = bem::assembleOperators(space, lame);
  const Index n = space.displacements();
  const Index size = n + space.densities();
  const contact::State state = stateOf(multiplier.size());
  const auto lower = [](const Matrix& a, Index i, Index j) {
    return a(std::max(i, j), std::min(i, j));
  };
  Matrix system(size, size);
  Vector right(at(size));
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < n; ++i)
      system(i, j) = lower(operators.hypersingular, i, j);
    for (Index i = n; i < size; ++i)
      system(i, j) = system(j, i) = operators.doubleLayer(i - n, j);
  }
  for (Index j = n; j < size; ++j)
    for (Index i = n; i < size; ++i)
      system(i, j) = -lower(operators.singleLayer, i - n, j - n);

  const bem::Rule& rule = bem::gaussLegendre(c.degree + 4);
  struct Point {
    const contact::MultiplierSpace::ContactElement* element;
    double gamma, weight, t;
    Vec2 stress;
  };
  std::vector<Point> points;
  const auto stressOf = [&](const Vector& lambda, const Point& point) {
    const auto value = multiplier.at(lambda, *point.element, point.t);
    const Vec2 normal = mesh[point.element->element].segment().normal;
    return value.normal * normal + value.tangential * turnLeft(normal);
  };
  for (const auto& element : multiplier.elements()) {
    const bem::Element& e = mesh[element.element];
    const double h = 2 * std::min({e.half, mesh[e.previous].half, mesh[e.next].half});
    for (int q = 0; q < rule.size(); ++q) {
      Point point{&element,
                  c.gamma0 * h / (c.degree * c.degree),
                  e.half * rule.weights[q],
                  rule.points[q],
                  {}};
      point.stress = stressOf(state.multiplier, point);
      points.push_back(point);
    }
  }
  const auto unit = [](Index k, Index of) {
    Vector vector(at(of));
    vector[k] = 1;
    return vector;
  };
  for (const Point& point : points) {
    const int e = point.element->element;
    const bem::Element& element = mesh[e];
    for (int k = 0; k <= element.degree; ++k)
      for (int d = 0; d < 2; ++d) {
        const Index row = space.displacement(e, k, d);
        right[row] -=
            point.weight *
            dot(bem::DisplacementField(space, unit(row, n)).at(e, point.t), point.stress);
      }
    for (int i = 0; i < element.densities; ++i)
      for (int d = 0; d < 2; ++d) {
        const Index row = space.density(e, i, d);
        const Vec2 p = space.densityAt(unit(row, size - n), e, point.t);
        right[n + row] += point.weight * point.gamma * dot(p, point.stress);
        for (int j = 0; j < element.densities; ++j) {
          const Index column = space.density(e, j, d);
          system(n + row, n + column) -=
              point.weight * point.gamma *
              dot(p, space.densityAt(unit(column, size - n), e, point.t));
        }
      }
  }
  // loads by linear tractions: exact with any rule for degree p + 1
  for (const int e : mesh.elementsOf("top"))
    for (int q = 0; q < rule.size(); ++q)
      for (int k = 0; k <= c.degree; ++k)
        for (int d = 0; d < 2; ++d) {
          const Index row = space.displacement(e, k, d);
          const double t = rule.points[q];
          const Vec2 x = mesh.physicalPoint(e, t);
          right[row] += mesh[e].half * rule.weights[q] *
                        dot(bem::DisplacementField(space, unit(row, n)).at(e, t),
                            Vec2{0.01, -0.1 * (1 + x.x)});
        }
  for (const int e : mesh.elementsOf("left"))
    for (int k = 0; k <= c.degree; ++k)
      for (int d = 0; d < 2; ++d) {
        const Index row = space.displacement(e, k, d);
        for (Index j = 0; j < size; ++j)
          system(row, j) = system(j, row) = row == j ? 1 : 0;
        right[row] = 0;
      }

  const bem::LuFactor factor(std::move(system));
  factor.solve(right);
  Condensed result;
  result.displacement.assign(right.begin(), right.begin() + n);
  result.density.assign(right.begin() + n, right.end());
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      result.energy += 0.5 * lower(operators.hypersingular, i, j) *
                       result.displacement[i] * result.displacement[j];
  for (Index j = 0; j < size - n; ++j)
    for (Index i = 0; i < size - n; ++i)
      result.energy += 0.5 * lower(operators.singleLayer, i, j) * result.density[i] *
                       result.density[j];
  result.residual.assign(at(multiplier.size()), factor.isRegular() ? 0.0 : 1e9);
  for (Index i = 0; i < multiplier.size(); ++i) {
    const Vector chi = unit(i, multiplier.size());
    for (const Point& point : points) {
      const int e = point.element->element;
      const Vec2 slack =
          point.gamma * (point.stress + space.densityAt(result.density, e, point.t));
      const Vec2 u = bem::DisplacementField(space, result.displacement).at(e, point.t);
      const Vec2 direction = stressOf(chi, point);
      const double gap = 0.01 * mesh.physicalPoint(e, point.t).x;
      result.residual[i] +=
          point.weight *
          (dot(direction, u - slack) - gap * dot(direction, mesh[e].segment().normal));
    }
  }
  return result;
}

double apart(const Vector& a, const Vector& b) {
  return test::largestDifference(a, b) / test::largest(b);
}

TEUCHOS_UNIT_TEST(Density, theCondensedProblemIsTheSaddlePoint) {
  const Case cases[] = {
      {{3, 2, 3, 2}, 1, "Gauss-Legendre-Lagrange", "Coulomb", false, 0.3, 0.5},
      {{2, 2, 3, 2}, 3, "Gauss-Lobatto-Lagrange", "Tresca", false, 0.3, 0.5},
      {{2, 3, 2, 2}, 2, "Bernstein", "None", false, 0.3, 1e4},
      {{2, 3, 2, 2}, 2, "Bernstein", "Coulomb", false, -0.5, 1e-6},
      {{3, 2, 3, 2}, 2, "Gauss-Legendre-Lagrange", "Coulomb", false, 0.5, 0.5},
      {{9, 4, 6, 5}, 1, "Gauss-Legendre-Lagrange", "Coulomb", true, 0.3, 0.5},
      {{2, 9, 3, 2}, 3, "Gauss-Lobatto-Lagrange", "Tresca", true, 0.5, 0.5},
  };
  for (const Case& c : cases) {
    const Condensed small = condensed(c);
    const Condensed large = whole(c);
    TEST_COMPARE(apart(small.displacement, large.displacement), <, 1e-11);
    TEST_COMPARE(apart(small.density, large.density), <, 1e-9);
    TEST_COMPARE(apart(small.residual, large.residual), <, 1e-10);
    TEST_COMPARE(std::abs(small.energy / large.energy - 1), <, 1e-10);
    // what a residual leaves open: 2^(q+1) - 1 of control points
    TEST_EQUALITY(small.amplification,
                  c.basis == std::string("Bernstein") ? std::exp2(c.degree + 1) - 1 : 1);
  }
}

}  // namespace

}  // namespace epafi
