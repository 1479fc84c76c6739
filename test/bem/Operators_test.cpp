// The Galerkin matrices against 33 digits (a sample; all of it in
// OperatorsConvergence_test) and against identities that hold for whole problems.
#include "Largest.hpp"
#include "Message.hpp"
#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/ExactFields.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::reference {

namespace {

using bem::Vec2;
using bem::Vector;
using test::largest;

bem::Lame lameOf(double nu) { return bem::Lame({1, nu, false}); }

/// (K + 1/2) u - V t, which vanishes for the Cauchy data of a solution.
double calderonResidual(const bem::Operators& operators, const Vector& u,
                        const Vector& t) {
  return test::largestDifference(bem::product(operators.doubleLayer, u),
                                 bem::multiplySymmetric(operators.singleLayer, t));
}

TEUCHOS_UNIT_TEST(Lame, followsTheReferenceStress) {
  const bem::Material material{8, 0.3, true};
  const bem::Lame own(material);
  const bem::Lame shared(material, 2);  // four times as stiff as the reference
  TEST_FLOATING_EQUALITY(shared.mu, 4 * own.mu, 1e-15);
  TEST_FLOATING_EQUALITY(shared.d, 4 * own.d, 1e-15);
  TEST_FLOATING_EQUALITY(4 * shared.a, own.a, 1e-15);
  TEST_FLOATING_EQUALITY(4 * shared.b, own.b, 1e-15);
  const double pi = std::acos(-1.0);
  TEST_FLOATING_EQUALITY(2 * pi * shared.mu * (shared.a + shared.b), 1.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Operators, areExactTo12DigitsOfTheirBlocks) {
  for (const Sample& sample : quickSamples())
    for (double nu : {0.3, 0.4999999}) {
      const bem::Space space(sample.mesh);
      const OperatorErrors error = operatorErrors(
          bem::assembleOperators(space, lameOf(nu)), quadOperators(space, lameOf(nu)));
      out << sample.name << ", nu = " << nu << ": ";
      TEST_COMPARE(error.singleLayer, <, 1e-12);
      TEST_COMPARE(error.doubleLayer, <, 1e-12);
      TEST_COMPARE(error.hypersingular, <, 1e-12);
    }
}

TEUCHOS_UNIT_TEST(Matrix, isEmptyWhenItsEntriesAreMovedElsewhere) {
  bem::Matrix from(3, 2);
  const bem::Matrix to = std::move(from);
  TEST_EQUALITY(to.columns(), 2);
  TEST_EQUALITY(from.rows(), 0);  // NOLINT(bugprone-use-after-move)
  TEST_ASSERT(from.empty());
}

// The comparison above would be worthless if it could not tell materials apart.
TEUCHOS_UNIT_TEST(Operators, ofAnotherMaterialAreToldApart) {
  const bem::Space space(quickSamples().front().mesh);
  const OperatorErrors error =
      operatorErrors(bem::assembleOperators(space, lameOf(0.3 + 1e-10)),
                     quadOperators(space, lameOf(0.3)));
  TEST_COMPARE(error.singleLayer, >, 1e-12);
  TEST_COMPARE(error.doubleLayer, >, 1e-12);
  TEST_COMPARE(error.hypersingular, >, 1e-12);
}

TEUCHOS_UNIT_TEST(Operators, annihilateRigidMotions) {
  for (const Sample& sample : hardSamples())
    for (double nu : {-0.5, 0.3, 0.4999999}) {
      const bem::Space space(sample.mesh);
      const bem::Operators operators = bem::assembleOperators(space, lameOf(nu));
      const bem::Matrix motions = space.rigidMotions();
      for (int k = 0; k < 3; ++k) {
        const Vector r(motions.column(k), motions.column(k) + motions.rows());
        out << sample.name << ", nu = " << nu << ": ";
        TEST_COMPARE(largest(bem::product(operators.doubleLayer, r)), <, 1e-14);
        TEST_COMPARE(largest(bem::multiplySymmetric(operators.hypersingular, r)), <,
                     1e-14 * largest(operators.hypersingular));
      }
    }
}

TEUCHOS_UNIT_TEST(Operators, satisfyCalderonsIdentityForConstantStress) {
  for (const Sample& sample : hardSamples())
    for (double nu : {0.3, 0.4999999})
      for (const PlaneStressTensor sigma :
           {PlaneStressTensor{1, 0, 0}, PlaneStressTensor{0, 1, 0},
            PlaneStressTensor{0, 0, 1}}) {
        const bem::Space space(sample.mesh);
        const bem::Operators operators = bem::assembleOperators(space, lameOf(nu));
        const ExactField field = constantStress(lameOf(nu), sigma, 0.3);
        out << sample.name << ", nu = " << nu << ": ";
        TEST_COMPARE(calderonResidual(operators, displacementOf(space, field),
                                      tractionOf(space, field)),
                     <, 1e-14);
      }
}

/// Error of the traction V⁻¹ (K + 1/2) u for the interpolated displacement of a point
/// force.
double pointForceError(const bem::Mesh& mesh, double nu) {
  const bem::Space space(mesh);
  const ExactField field = pointForce(lameOf(nu), {0.8, 0.5}, {0.6, -0.8});
  bem::Operators operators = bem::assembleOperators(space, lameOf(nu));
  const Vector right = bem::product(operators.doubleLayer, displacementOf(space, field));
  const bem::CholeskyFactor factor(std::move(operators.singleLayer), "V");
  return tractionError(space, factor.solve(right), field);
}

std::shared_ptr<const bem::Outline> squareOutline() { return outlineOf(square()); }

// Down to rounding: u's last digit changes the volume, and a nearly incompressible body
// answers with a pressure 1/(1-2nu) times as large.
TEUCHOS_UNIT_TEST(Operators, giveThePointForcesTractionExponentiallyInP) {
  for (const auto& shape : {squareOutline(), squareWithHole()})
    for (double nu : {0.3, 0.4999999}) {
      const std::vector<int> two(shape->edges().size(), 2);
      const double rounding = std::max(1e-12, 1e-15 / (1 - 2 * nu));
      double before = pointForceError(bem::makeMesh(shape, two, 2), nu);
      for (int p = 6; p <= 18; p += 4) {
        const double error = pointForceError(bem::makeMesh(shape, two, p), nu);
        out << "nu = " << nu << ", p = " << p << ": ";
        TEST_COMPARE(error, <, std::max(0.02 * before, rounding));
        before = error;
      }
      TEST_COMPARE(before, <, rounding);
    }
}

TEUCHOS_UNIT_TEST(Operators, doNotDependOnUnitsOrOnTheOrigin) {
  const auto assemble = [](double factor, Vec2 shift) {
    bem::Loop loop = polygon({{0, 0}, {1, 0}, {1.25, 0.5}, {0, 0.75}});
    for (Vec2& v : loop.vertices)
      v = factor * (v + shift);
    return bem::assembleOperators(
        bem::Space(bem::makeMesh(outlineOf(loop), {2, 1, 1, 2}, 3)), lameOf(0.3));
  };
  const bem::Operators one = assemble(1, {0, 0});
  for (const bem::Operators& other : {assemble(1000, {0, 0}), assemble(1e-3, {0, 0}),
                                      assemble(1, {8, -4}), assemble(1e6, {0.5, 0.5})}) {
    TEST_COMPARE(test::relativeDifference(other.singleLayer, one.singleLayer), <, 1e-14);
    TEST_COMPARE(test::relativeDifference(other.doubleLayer, one.doubleLayer), <, 1e-14);
    TEST_COMPARE(test::relativeDifference(other.hypersingular, one.hypersingular), <,
                 1e-14);
  }
}

TEUCHOS_UNIT_TEST(CholeskyFactor, namesTheRowWhereAMatrixIsIndefinite) {
  constexpr bem::Index n = 130;
  for (const bem::Index row : {bem::Index(0), n / 2, n - 1}) {
    bem::Matrix a(n, n);
    for (bem::Index i = 0; i < n; ++i)
      a(i, i) = i == row ? -1 : 1;
    const std::string told = test::messageOf<bem::NumericalError>(
        [&] { bem::CholeskyFactor(std::move(a), "A"); });
    TEST_ASSERT(test::contains(told, "A is not positive definite"));
    TEST_ASSERT(test::contains(told, bem::message("row ", row + 1, " of ", n)));
  }
}

TEUCHOS_UNIT_TEST(Mesh, refusesDensitiesBeyondTheLargestDegree) {
  const auto outline = outlineOf(square());
  const bem::Mesh mesh = bem::makeMesh(outline, {1, 1, 1, 1}, bem::largestDegree - 1);
  const std::vector<int> most(4, bem::largestDegree);
  TEST_EQUALITY(mesh.withDensities(most)[0].densities, bem::largestDegree);
  const std::vector<int> more(4, bem::largestDegree + 1);
  TEST_THROW(mesh.withDensities(more), bem::InputError);
}

TEUCHOS_UNIT_TEST(Mesh, refusesPiecesInAnotherOrderThanTheEdges) {
  const auto outline = outlineOf(square());
  const bem::Mesh mesh = bem::makeMesh(outline, {2, 2, 2, 2}, 1);
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements())
    pieces.push_back(element.piece);
  TEST_EQUALITY(bem::Mesh(outline, pieces).size(), 8);
  std::rotate(pieces.begin(), pieces.begin() + 2, pieces.end());
  TEST_THROW(bem::Mesh(outline, pieces), bem::InputError);
}

}  // namespace

}  // namespace epafi::reference
