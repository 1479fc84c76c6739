// Laplace's operators against 33 digits, harmonic functions from their data, and Cauchy's integrals.
#include "bem/operators/Laplace.hpp"

#include "Largest.hpp"
#include "bem/fields/CauchyIntegral.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::reference {

namespace {

using bem::Complex;
using bem::Index;
using bem::Vec2;

// Of the blocks of Kelvin's operators the traces: of V  2A ∫∫ -log|w| + B ∫∫ 1, of K  2 K_Δ.
TEUCHOS_UNIT_TEST(Laplace, operatorsAreExactTo12DigitsOfTheirBlocks) {
  constexpr double twoPi = 6.283185307179586;
  for (const Sample& sample : quickSamples()) {
    const bem::Space space(sample.mesh);
    const bem::Lame lame(bem::Material{1, 0.3, false});
    const QuadOperators exact = quadOperators(space, lame);
    const bem::MixedLaplace laplace(
        space, std::vector<bool>(static_cast<std::size_t>(sample.mesh.size()), true));
    std::vector<double> whole(static_cast<std::size_t>(space.densities() / 2));
    for (int e = 0; e < sample.mesh.size(); ++e)
      whole[static_cast<std::size_t>(flowOf(space, e, 0))] = 2 * sample.mesh[e].half;
    double worst = 0;
    const Index flows = space.densities() / 2;
    const bem::Matrix& found = laplace.operators();
    for (Index i = 0; i < flows; ++i) {
      for (Index j = 0; j < flows; ++j) {
        const Quad trace = exact.singleLayer(2 * i, 2 * j) +
                           exact.singleLayer(2 * i + 1, 2 * j + 1) -
                           Quad(lame.b) * whole[static_cast<std::size_t>(i)] *
                               whole[static_cast<std::size_t>(j)];
        const auto error =
            static_cast<double>(trace / Quad(2 * twoPi * lame.a) - found(i, j));
        const auto scale = static_cast<double>(exact.singleLayer.scale(2 * i, 2 * j));
        worst = std::max(worst, std::abs(error) / scale);
      }
      for (Index j = 0; 2 * j < space.displacements(); ++j) {
        const Quad trace =
            exact.doubleLayer(2 * i, 2 * j) + exact.doubleLayer(2 * i + 1, 2 * j + 1);
        const auto error = static_cast<double>(trace / Quad(2) + found(i, flows + j));
        const auto scale = static_cast<double>(exact.doubleLayer.scale(2 * i, 2 * j));
        worst = std::max(worst, scale > 0 ? std::abs(error) / scale : std::abs(error));
      }
    }
    out << sample.name << ": ";
    TEST_COMPARE(worst, <, 1e-12);
  }
}

/// z³ + (1 - 2i) z² + 3z
Complex function(Complex z) { return z * z * z + Complex(1, -2) * z * z + 3.0 * z; }
Complex slopeOf(Complex z) { return 3.0 * z * z + 2.0 * Complex(1, -2) * z + 3.0; }

/// T on every second element and q on the others give back both.
double errorOf(const bem::Mesh& mesh) {
  const bem::Space space(mesh);
  std::vector<bool> held;
  for (int e = 0; e < mesh.size(); ++e)
    held.push_back(e % 2 == 0);
  bem::Vector exact(
      static_cast<std::size_t>((space.densities() + space.displacements()) / 2));
  const bem::Vector values = space.interpolate([](Vec2 x) {
    return Vec2{function(bem::asComplex(x)).real(), 0};
  });
  for (Index j = 0; 2 * j < space.displacements(); ++j)
    exact[static_cast<std::size_t>(space.densities() / 2 + j)] =
        values[static_cast<std::size_t>(2 * j)];
  for (int e = 0; e < mesh.size(); ++e) {
    const auto flow = bem::project(
        [&](double t) {
          return (slopeOf(bem::asComplex(mesh.scaledPoint(e, t))) *
                  bem::asComplex(mesh[e].curve.normal(t)))
              .real();
        },
        mesh[e].densities - 1);
    for (int i = 0; i < mesh[e].densities; ++i)
      exact[static_cast<std::size_t>(flowOf(space, e, i))] =
          flow[static_cast<std::size_t>(i)];
  }
  const double worst =
      test::largestDifference(bem::MixedLaplace(space, held).solve(exact), exact);
  return worst;
}

TEUCHOS_UNIT_TEST(Laplace, solvesMixedProblemsForPolynomials) {
  const auto square = outlineOf(reference::square());
  TEST_COMPARE(errorOf(bem::makeMesh(square, {2, 2, 2, 2}, 4)), <, 1e-12);
  TEST_COMPARE(errorOf(bem::makeMesh(squareWithHole(), {1, 2, 2, 1, 1, 2, 1, 1}, 4)), <,
               1e-12);
}

TEUCHOS_UNIT_TEST(Laplace, convergesOnArcs) {
  const auto outline = outlineOf(curvedSample());
  const std::vector<int> counts(outline->edges().size(), 2);
  const double coarse = errorOf(bem::makeMesh(outline, counts, 4));
  const double fine = errorOf(bem::makeMesh(outline, counts, 8));
  out << coarse << ", " << fine << ": ";
  TEST_COMPARE(fine, <, 1e-3 * coarse);
}

// of their boundary values
TEUCHOS_UNIT_TEST(CauchyIntegral, givesAnalyticFunctionsInsideAndOnTheBoundary) {
  const auto curved = outlineOf(curvedSample());
  for (const auto& outline : {squareWithHole(), curved}) {
    const std::vector<int> counts(outline->edges().size(), 3);
    const bem::Mesh mesh = bem::makeMesh(outline, counts, 1);
    std::vector<std::array<bem::CauchyIntegral::Series, 2>> densities;
    for (int e = 0; e < mesh.size(); ++e) {
      const auto of = [&](const auto& f) {
        return bem::project(
            [&](double t) { return f(bem::asComplex(mesh.scaledPoint(e, t))); },
            bem::largestDegree);
      };
      densities.push_back(
          {of(function), of([](Complex z) { return std::exp(2.0 * z); })});
    }
    const bem::CauchyIntegral cauchy(mesh, densities);
    double worst = 0;
    const auto compare = [&](const bem::CauchyIntegral::Pair& found, Vec2 x) {
      const Complex z = bem::asComplex(x);
      worst = std::max({worst, std::abs(found[0] - function(z)),
                        std::abs(found[1] - std::exp(2.0 * z))});
    };
    std::vector<Vec2> points;
    for (int e = 0; e < mesh.size(); ++e)
      for (const double depth : {1e-9, 1e-3}) {
        const Vec2 x = mesh.scaledPoint(e, 0.3) - depth * mesh[e].curve.normal(0.3);
        if (outline->contains(outline->physical(x)))
          points.push_back(x);
      }
    TEST_COMPARE(points.size(), >, 10U);
    const auto inside = cauchy.at(points);
    for (std::size_t k = 0; k < points.size(); ++k)
      compare(inside[k], points[k]);
    out << worst << " inside: ";
    TEST_COMPARE(worst, <, 1e-12);
    const bem::Vector places = {-0.999999, -0.5, 0.1, 0.8};
    for (int e = 0; e < mesh.size(); ++e) {
      const auto values = cauchy.on(e, places);
      for (std::size_t k = 0; k < places.size(); ++k)
        compare(values[k], mesh.scaledPoint(e, places[k]));
    }
    out << worst << " on the boundary: ";
    TEST_COMPARE(worst, <, 1e-12);
  }
}

}  // namespace

}  // namespace epafi::reference
