#include "adaptivity/estimate/Layer.hpp"

#include "Rectangle.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

using adaptivity::Layer;
using adaptivity::layerBehind;
using bem::Vec2;

namespace {

const bem::Lame compressible({1, 0.3, false});
const bem::Lame incompressible({1, 0.5, false});

/// 4 by 0.1, in outline diameters nearly 1 by 0.025.
bem::Mesh stripMesh() {
  return bem::makeMesh(test::outlineOf(test::rectangle({-2, 3}, 4, 0.1)), {4, 1, 5, 1},
                       1);
}

/// m' of m = P_k across and 2 P_k along a bottom side, at Gauss points.
std::vector<bem::BoundaryValue> slopes(const bem::Element& element, int k) {
  std::vector<bem::BoundaryValue> values;
  const bem::Rule& rule = bem::gaussLegendre(128);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const double t = rule.points[q];
    double legendre[bem::largestDegree + 1];
    bem::legendreValues(k, t, legendre);
    const double slope =
        k * (legendre[k - 1] - t * legendre[k]) / ((1 - t * t) * element.half);
    bem::BoundaryValue value;
    value.place = {t, 1 + t, 1 - t};
    value.weight = element.half * rule.weights[q];
    value.mismatch = slope * (element.curve.normal(t) + 2.0 * element.curve.tangent(t));
    values.push_back(value);
  }
  return values;
}

}  // namespace

TEUCHOS_UNIT_TEST(Layer, isWhatLiesBehindThroughTheBody) {
  const bem::Mesh mesh = stripMesh();
  const double length = mesh.outline().diameter();
  contact::Conditions conditions;
  conditions.dirichlet["bottom"] = {[](Vec2) { return 0.0; }, [](Vec2) { return 0.0; }};
  for (int e = 0; e < mesh.size(); ++e) {
    const Layer layer = layerBehind(mesh, conditions, e);
    const bool isLong = mesh.boundary(e) == "bottom" || mesh.boundary(e) == "top";
    TEST_FLOATING_EQUALITY(layer.thickness * length, isLong ? 0.1 : 4.0, 1e-12);
    TEST_EQUALITY(layer.isHeld, mesh.boundary(e) == "top");
  }
}

TEUCHOS_UNIT_TEST(Layer, isAHalfPlaneForWhatVariesFasterThanItIsThick) {
  for (const bem::Lame* lame : {&compressible, &incompressible})
    for (const double length : {1e-3, 0.05, 0.1}) {
      const Layer::Stiffness beyond = Layer{0.1}.beyondHalfPlane(*lame, length);
      TEST_EQUALITY(beyond.across, 0);
      TEST_EQUALITY(beyond.along, 0);
    }
}

// Two sides that move against each other by twice m each have half of the energy: M and μ per
// thickness, and with nu = 1/2 what lubrication needs, pressure'' = 12 μ (2 m) / thickness³.
TEUCHOS_UNIT_TEST(Layer, isAsStiffAsItsCompressionItsShearAndItsSqueezing) {
  const double thickness = 1e-4;
  const Layer layer{thickness};
  const Layer::Stiffness stiff = layer.beyondHalfPlane(compressible, 1);
  TEST_FLOATING_EQUALITY(stiff.across * thickness, 7.0, 1e-3);
  TEST_FLOATING_EQUALITY(stiff.along * thickness, 2.0, 1e-3);
  for (int k = 1; k <= 8; ++k) {
    // of p'' = 24 m / thickness³ for m = P_k on an element of length 1, energy p'² thickness³ / 24
    const double integral = std::pow(0.5, 3) / std::pow(2 * k + 1.0, 2) *
                            (2 / (2 * k + 3.0) + 2 / (2 * k - 1.0));
    const double squeezed = 24 / std::pow(thickness, 3) * integral;
    const double counted =
        layer.beyondHalfPlane(incompressible, 1.0 / k).across / (2 * k + 1);
    TEST_COMPARE(counted, >=, (1 - 1e-6) * squeezed);
    TEST_COMPARE(counted, <, 1.32 * squeezed);
  }
}

TEUCHOS_UNIT_TEST(Layer, weighsEachLegendreTermForItsLength) {
  const bem::Mesh mesh = stripMesh();
  const bem::Element& element = mesh[1];
  const Layer layer{0.02 * element.half};
  for (const int k : {1, 2, 5}) {
    const Layer::Stiffness stiff =
        layer.beyondHalfPlane(compressible, 2 * element.half / k);
    const double expected =
        (stiff.across + 4 * stiff.along) * 2 * element.half / (2 * k + 1);
    TEST_FLOATING_EQUALITY(layer.square(compressible, mesh, 1, slopes(element, k)),
                           expected, 1e-2);
  }
  TEST_EQUALITY(Layer{}.square(compressible, mesh, 1, slopes(element, 1)), 0);
}

}  // namespace epafi
