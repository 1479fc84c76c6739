// The energy norm of a difference, on the union of two meshes.
#include "bem/operators/EnergyNorm.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <numeric>
#include <random>

namespace epafi::reference {

namespace {

using bem::Index;
using bem::Vec2;
using bem::Vector;

const bem::Lame lame({1, 0.3, false});

Vector random(Index size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Vector v(size);
  for (double& x : v)
    x = uniform(generator);
  return v;
}

double quadratic(const bem::Matrix& lower, const Vector& v) {
  const Vector product = bem::multiplySymmetric(lower, v);
  return std::inner_product(v.begin(), v.end(), product.begin(), 0.0);
}

/// By the Galerkin matrices.
double normByMatrices(const bem::Space& space, const Vector& u, const Vector& psi) {
  const bem::Operators operators = bem::assembleOperators(space, lame);
  return std::sqrt(quadratic(operators.hypersingular, u) +
                   quadratic(operators.singleLayer, psi));
}

/// A quadratic displacement and a linear density, which degree 2 holds on every mesh.
bem::CauchyData smooth(const bem::Space& space) {
  const auto displacement = [](Vec2 x) {
    return Vec2{1 + x.x * x.y - 2 * x.y * x.y, 3 * x.x * x.x - x.y};
  };
  const auto density = [](Vec2 x) { return Vec2{x.x - 2 * x.y, 0.5 + x.y}; };
  Vector psi(space.densities());
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Vec2 start = density(space.mesh().scaledPoint(e, -1));
    const Vec2 end = density(space.mesh().scaledPoint(e, 1));
    const Vec2 mean = 0.5 * (start + end);
    const Vec2 slope = 0.5 * (end - start);
    psi[space.density(e, 0, 0)] = mean.x;
    psi[space.density(e, 0, 1)] = mean.y;
    psi[space.density(e, 1, 0)] = slope.x;
    psi[space.density(e, 1, 1)] = slope.y;
  }
  return bem::makeCauchyData(space, space.interpolate(displacement), psi);
}

std::shared_ptr<const bem::Outline> squareOutline() { return outlineOf(square()); }

TEUCHOS_UNIT_TEST(EnergyNorm, isThatOfTheGalerkinMatrices) {
  for (const Sample& sample : quickSamples()) {
    const bem::Space space(sample.mesh);
    const Vector u = random(space.displacements(), 1);
    const Vector psi = random(space.densities(), 2);
    out << sample.name << ": ";
    TEST_FLOATING_EQUALITY(bem::energyNorm(bem::makeCauchyData(space, u, psi), lame),
                           normByMatrices(space, u, psi), 1e-11);
  }
}

TEUCHOS_UNIT_TEST(EnergyNorm, doesNotSeeTheMeshThatAFunctionIsWrittenOn) {
  const auto outline = squareOutline();
  const bem::Mesh coarse = bem::makeMesh(outline, {1, 2, 1, 1}, 2);
  const bem::Mesh meshes[] = {
      bem::makeMesh(outline, {4, 2, 8, 1}, 3),  // nested
      cutMesh(outline, {{0, {0.3}}, {1, {0.7}}, {2, {1e-9, 1e-6, 0.1}}}, {2, 5, 3})};
  const bem::CauchyData data = smooth(bem::Space(coarse));
  for (const bem::Mesh& mesh : meshes) {
    const bem::CauchyData same = smooth(bem::Space(mesh));
    const double norm = bem::energyNorm(data, lame);
    TEST_COMPARE(norm, >, 0.1);
    TEST_FLOATING_EQUALITY(bem::energyNorm(same, lame), norm, 1e-11);
    TEST_COMPARE(bem::energyNorm(bem::difference(data, same), lame), <, 1e-13 * norm);
    TEST_COMPARE(bem::energyNorm(bem::difference(same, data), lame), <, 1e-13 * norm);
  }
}

TEUCHOS_UNIT_TEST(EnergyNorm, ofADifferenceIsWhatTheFinerSpaceSays) {
  const auto outline = squareOutline();
  const bem::Space coarse(bem::makeMesh(outline, {1, 2, 1, 1}, 2));
  const bem::Space fine(bem::makeMesh(outline, {4, 2, 8, 1}, 3));
  const Vector u = random(fine.displacements(), 5);
  const Vector psi = random(fine.densities(), 6);
  bem::CauchyData shifted = smooth(fine);
  const bem::CauchyData extra = bem::makeCauchyData(fine, u, psi);
  for (std::size_t e = 0; e < shifted.fields.size(); ++e)
    for (std::size_t i = 0; i < extra.fields[e].slope.size(); ++i) {
      shifted.fields[e].value[i] += extra.fields[e].value[i];
      shifted.fields[e].slope[i] += extra.fields[e].slope[i];
      shifted.fields[e].density[i] += extra.fields[e].density[i];
    }
  TEST_FLOATING_EQUALITY(bem::energyNorm(bem::difference(shifted, smooth(coarse)), lame),
                         normByMatrices(fine, u, psi), 1e-10);
}

TEUCHOS_UNIT_TEST(UnionMesh, hasTheNodesOfBothOnceAndTheLargerDegrees) {
  const auto outline = squareOutline();
  const double third = 1.0 / 3;
  const bem::Mesh a = cutMesh(outline, {{0, {third, 2 * third}}}, {2});
  const bem::Mesh b = cutMesh(outline, {{0, {third * (1 + 1e-15), 0.5}}}, {1, 4, 1});
  const bem::UnionMesh both = bem::unite(a, b);
  TEST_EQUALITY(both.mesh.size(), 4 + 3);
  const int degrees[] = {2, 4, 2, 2};
  for (int e = 0; e < 4; ++e) {
    TEST_EQUALITY(both.mesh[e].degree, degrees[e]);
    TEST_COMPARE(both.mesh[e].half, >, 0.05);
  }
  TEST_EQUALITY(both.first[2].element, 1);  // [1/2, 2/3] in [1/3, 2/3]: t in [0, 1]
  TEST_FLOATING_EQUALITY(both.first[2].middle, 0.5, 1e-13);
  TEST_FLOATING_EQUALITY(both.first[2].scale, 0.5, 1e-13);
  TEST_EQUALITY(both.second[3].element, 2);
}

// Grading leads to such elements: what is rounding in the middle of an edge is not at its
// ends.
TEUCHOS_UNIT_TEST(UnionMesh, tellsNodesNextToAVertexApart) {
  const auto outline = squareOutline();
  const bem::Mesh a = cutMesh(outline, {{0, {1e-13, 1e-10}}}, {1});
  const bem::Mesh b = cutMesh(outline, {{0, {3e-13, 0.5}}}, {1});
  const bem::UnionMesh both = bem::unite(a, b);
  TEST_EQUALITY(both.mesh.size(), 5 + 3);
  TEST_FLOATING_EQUALITY(both.mesh[1].half / both.mesh[0].half, 2.0, 1e-12);
}

}  // namespace

}  // namespace epafi::reference
