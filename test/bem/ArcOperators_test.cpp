// Operators and fields on bodies with arcs against closed forms.
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/fields/Interior.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "reference/ExactFields.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::reference {

namespace {

using bem::Vec2;
using bem::Vector;

const bem::Lame lame({1, 0.3, false});

double product(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// cos(k θ) and sin(k θ) of a point about the origin.
Vec2 wave(Vec2 x, int k) {
  const double angle = k * std::atan2(x.y, x.x);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

// [doc/theory/operators.md]  S e^{ikθ} = 2μk/(κR) e^{ikθ}, k >= 2, and so on.
TEUCHOS_UNIT_TEST(ArcOperators, haveTheEigenvaluesOfTheDisc) {
  const bem::Space space(meshOf(disc(4, 0.5), 2, 12));
  const bem::SteklovPoincare s(bem::assembleOperators(space, lame));
  const double radius = 0.5;
  const double kappa = 3 - 4 * lame.nu;
  for (int k = -4; k <= 4; ++k) {
    const Vector u = space.interpolate([&](Vec2 x) { return wave(x, k); });
    double expected =
        k >= 2 ? 2 * lame.mu * k / (kappa * radius) : 2 * lame.mu * std::abs(k) / radius;
    if (k == 1)
      expected = 2 * lame.mu / ((1 - 2 * lame.nu) * radius);
    // <u, u> = 2 π R
    const double value = product(u, s.apply(u)) / (2 * std::acos(-1.0) * radius);
    out << "k = " << k << ": ";
    TEST_COMPARE(std::abs(value - expected), <, k == 0 ? 1e-13 : 1e-12);
  }
}

// [doc/theory/operators.md]  On arcs rotations are no polynomials of arc length.
TEUCHOS_UNIT_TEST(ArcOperators, storeNoEnergyInARigidMotion) {
  for (const int degree : {1, 2, 3}) {
    const bem::Space space(meshOf(disc(4, 0.5), 2, degree));
    const bem::SteklovPoincare s(bem::assembleOperators(space, lame));
    const bem::Matrix motions = space.rigidMotions();
    for (int k = 0; k < 3; ++k) {
      const Vector r(motions.column(k), motions.column(k) + motions.rows());
      out << "p = " << degree << ", motion " << k << ": ";
      TEST_COMPARE(std::abs(product(r, s.apply(r))), <, 1e-13);
    }
  }
}

// V 1 = c1 2 pi R (-log R + 1/(2 kappa)) 1
TEUCHOS_UNIT_TEST(ArcOperators, haveTheSingleLayerOfTheDisc) {
  const bem::Space space(meshOf(disc(4, 0.5), 2, 3));
  Vector ones(space.densities());
  for (int e = 0; e < space.mesh().size(); ++e)
    ones[space.density(e, 0, 0)] = 1;
  const Vector v =
      bem::multiplySymmetric(bem::assembleOperators(space, lame).singleLayer, ones);
  const double pi = std::acos(-1.0);
  const double exact = lame.a * pi * (std::log(2.0) + 1 / (2 * (3 - 4 * lame.nu)));
  TEST_FLOATING_EQUALITY(product(v, ones) / pi, exact, 1e-12);
}

TEUCHOS_UNIT_TEST(Interior, fieldsAreExactUpToTheBoundary) {
  for (const bem::Loop& loop : {disc(4, 0.5), square()})
    for (const double nu : {0.3, 0.45}) {
      const bem::Lame own({1, nu, false});
      const bem::Space space(meshOf(loop, 4, 16));
      const Vec2 outside = space.mesh().outline().scaled({1.1, -0.9});
      for (const ExactField& field : {constantStress(own, {0.4, -0.3, 0.2}, 0.7),
                                      pointForce(own, outside, {0.6, -0.8})}) {
        const Vector u = displacementOf(space, field);
        const bem::Interior inside(space, own, u, tractionOf(space, field));
        const auto check = [&](const Vec2& x) {
          const bem::InteriorValue value = inside.at(x);
          const PlaneStressTensor stress = field.stress(x);
          TEST_COMPARE(norm(value.displacement - field.displacement(x)), <, 1e-11);
          TEST_COMPARE(std::abs(value.xx - stress.xx) + std::abs(value.yy - stress.yy) +
                           std::abs(value.xy - stress.xy),
                       <, 1e-10);
        };
        check({0, 0});
        // beside a node and a corner, too
        for (const int e : {0, 3, 9})
          for (const double at : {-1 + 1e-9, -0.999, -0.3, 0.6})
            for (const double depth : {1e-9, 1e-6, 1e-3, 0.3, 3.0}) {
              const bem::Element& element = space.mesh()[e];
              const double t = depth < 1 ? std::max(at, depth - 1) : at;
              check(element.curve.point(t) -
                    (depth * element.half) * element.curve.normal(t));
            }
      }
    }
}

}  // namespace epafi::reference
