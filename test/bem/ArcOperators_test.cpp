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

namespace {

/// Meshes with so many elements that far ones act as groups.
std::vector<bem::Mesh> largeMeshes() {
  std::vector<double>
      toCorner;  // down to 1e-4: shorter ones are off by rounded coordinates
  for (int k = 70; k > 0; --k)
    toCorner.push_back(std::pow(0.88, k));
  std::vector<int> degrees = {1, 4, 2, 3};
  return {meshOf(disc(4, 0.5), 40, 2), meshOf(square(), 60, 1),
          meshOf(curvedSample(), 30, 3),
          bem::makeMesh(squareWithHole(), std::vector<int>(8, 25), 2),
          cutMesh(outlineOf(square()), {{0, toCorner}, {3, {0.3, 0.6}}}, degrees)};
}

/// Points inside: beside nodes, corners and middles of elements, and anywhere.
std::vector<Vec2> placesIn(const bem::Mesh& mesh) {
  std::vector<Vec2> places;
  const bem::Outline& outline = mesh.outline();
  const auto add = [&](Vec2 x) {
    if (outline.contains(outline.physical(x)))
      places.push_back(x);
  };
  for (int e = 0; e < mesh.size(); e += 3)
    for (const double t : {-1 + 1e-9, -0.7, 0.2})
      for (const double depth : {1e-9, 1e-4, 0.3, 4.0, 50.0})
        add(mesh[e].curve.point(t) - (depth * mesh[e].half) * mesh[e].curve.normal(t));
  for (int i = -9; i < 10; ++i)
    for (int j = -9; j < 10; ++j)
      add({i * 0.0501, j * 0.0499});
  return places;
}

}  // namespace

/// One point is asked of all elements in closed form, many of groups.
TEUCHOS_UNIT_TEST(Interior, manyPointsHaveTheFieldsOfEachAlone) {
  for (const bem::Mesh& mesh : largeMeshes()) {
    const bem::Space space(mesh);
    Vector u(bem::at(space.displacements()));
    Vector psi(bem::at(space.densities()));
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] = std::cos(1.7 * static_cast<double>(i * i));
    for (std::size_t i = 0; i < psi.size(); ++i)
      psi[i] = 100 * std::cos(0.9 * static_cast<double>(i * i));
    const bem::Interior inside(space, lame, u, psi);
    const std::vector<Vec2> places = placesIn(mesh);
    const std::vector<bem::InteriorValue> values = inside.at(places);
    double error = 0;
    double stressError = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bem::InteriorValue alone = inside.at(places[k]);
      const auto off = [&](double bem::InteriorValue::*part) {
        return std::abs(values[k].*part - alone.*part);
      };
      const double size =
          std::abs(alone.xx) + std::abs(alone.yy) + std::abs(alone.xy) + 1;
      error = std::max(error, norm(values[k].displacement - alone.displacement));
      stressError = std::max(
          stressError, (off(&bem::InteriorValue::xx) + off(&bem::InteriorValue::yy) +
                        off(&bem::InteriorValue::xy)) /
                           size);
    }
    out << mesh.size() << " elements, " << places.size() << " points: " << error << ", "
        << stressError << "\n";
    TEST_COMPARE(places.size(), >, 500);
    TEST_COMPARE(error, <, 1e-12);
    TEST_COMPARE(stressError, <, 1e-11);
  }
}

}  // namespace epafi::reference
