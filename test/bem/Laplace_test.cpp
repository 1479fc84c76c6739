// Laplace's V, K and W against 33 digits, identities on closed boundaries, Cauchy's integral.
#include "Largest.hpp"
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/fields/CauchyIntegral.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi::reference {

namespace {

using bem::Vec2;
using bem::Vector;
using test::largest;

TEUCHOS_UNIT_TEST(Laplace, operatorsAreExactTo12DigitsOfTheirBlocks) {
  for (const Sample& sample : quickSamples()) {
    const bem::Space space(sample.mesh, 1);
    const OperatorErrors error = operatorErrors(
        bem::assembleOperators(space, *bem::laplaceKernel()), quadLaplace(space));
    out << sample.name << ": ";
    TEST_COMPARE(error.singleLayer, <, 1e-12);
    TEST_COMPARE(error.doubleLayer, <, 1e-12);
    TEST_COMPARE(error.hypersingular, <, 1e-12);
  }
}

// K 1 = -1/2 and W 1 = 0.
TEUCHOS_UNIT_TEST(Laplace, constantsHaveNoFlux) {
  for (const Sample& sample : quickSamples()) {
    const bem::Space space(sample.mesh, 1);
    const bem::Operators operators = bem::assembleOperators(space, *bem::laplaceKernel());
    const bem::Matrix constant = space.rigidMotions();
    const Vector one(constant.column(0), constant.column(0) + constant.rows());
    TEST_COMPARE(largest(bem::product(operators.doubleLayer, one)), <,
                 1e-13 * largest(operators.doubleLayer));
    TEST_COMPARE(largest(bem::multiplySymmetric(operators.hypersingular, one)), <,
                 1e-13 * largest(operators.hypersingular));
  }
}

using Series = bem::CauchyIntegral::Series;

/// Of z² and 3i on all elements of a mesh, in scaled coordinates.
std::vector<std::array<Series, 2>> squares(const bem::Mesh& mesh) {
  std::vector<std::array<Series, 2>> all;
  for (int e = 0; e < mesh.size(); ++e) {
    const auto square = [&](double t) {
      const bem::Complex z = bem::asComplex(mesh.scaledPoint(e, t));
      return z * z;
    };
    all.push_back({bem::project(square, bem::largestDegree), Series{bem::Complex(0, 3)}});
  }
  return all;
}

// Of an analytic function it is that function, with groups of elements, too.
TEUCHOS_UNIT_TEST(CauchyIntegral, isTheAnalyticFunctionOfItsBoundaryValues) {
  for (const int perEdge : {4, 400}) {
    const bem::Mesh mesh =
        bem::makeMesh(outlineOf(square()), std::vector<int>(4, perEdge), 1);
    const bem::CauchyIntegral cauchy(mesh, squares(mesh));
    test::Largest error;
    const auto take = [&](Vec2 x, const bem::CauchyIntegral::Pair& values) {
      const bem::Complex z = bem::asComplex(x);
      error.take(std::abs(values[0] - z * z));
      error.take(std::abs(values[1] - bem::Complex(0, 3)));
    };
    std::vector<Vec2> inside;
    const bem::Complex middle =
        0.5 * bem::asComplex(mesh.scaledPoint(0, -1) + mesh.scaledPoint(2 * perEdge, -1));
    for (int e = 0; e < mesh.size(); e += 3)
      for (const double depth : {1e-9, 1e-3, 0.3}) {
        const bem::Complex z = bem::asComplex(mesh.scaledPoint(e, 0.3));
        inside.push_back(bem::asVector(z + depth * (middle - z)));
      }
    const auto found = cauchy.at(inside);
    for (std::size_t k = 0; k < inside.size(); ++k)
      take(inside[k], found[k]);
    const Vector places = {-0.999999, -0.5, 0, 0.7};
    for (int e = 0; e < mesh.size(); e += 7) {
      const auto on = cauchy.on(e, places);
      for (std::size_t k = 0; k < places.size(); ++k)
        take(mesh.scaledPoint(e, places[k]), on[k]);
    }
    TEST_COMPARE(error.size(), <, 1e-12);
  }
}

}  // namespace

}  // namespace epafi::reference
