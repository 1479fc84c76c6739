// The mixed problem of Laplace, by its compressed system, finds harmonic polynomials.
#include "CompressedSamples.hpp"
#include "Largest.hpp"
#include "bem/compressed/Laplace.hpp"
#include "bem/quadrature/LegendreSeries.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>

namespace epafi::reference {

namespace {

using bem::at;
using bem::Index;
using bem::Vec2;
using bem::Vector;

/// T = Re z² + x - 2y + 0.3 and its flux, an interpolant of the first and a projection of the
/// second.
Vector harmonic(const bem::Space& space) {
  const bem::Mesh& mesh = space.mesh();
  Vector data = space.interpolate([](Vec2 x) {
    return Vec2{x.x * x.x - x.y * x.y + x.x - 2 * x.y + 0.3, 0};
  });
  data.resize(at(space.displacements() + space.densities()));
  for (int e = 0; e < mesh.size(); ++e) {
    const auto flux = bem::project(
        [&](double t) {
          const Vec2 x = mesh.scaledPoint(e, t);
          return dot(Vec2{2 * x.x + 1, -2 * x.y - 2}, mesh[e].curve.normal(t));
        },
        bem::largestDegree);
    for (int i = 0; i < mesh[e].densities; ++i)
      data[at(flowOf(space, e, i))] = flux[at(i)];
  }
  return data;
}

/// Of T and of its fluxes through elements, T being of size 1.
double errorOfMixed(const bem::Mesh& mesh, const std::vector<bool>& isGiven) {
  const bem::Space space(mesh, 1);
  const Vector exact = harmonic(space);
  const Vector found = bem::MixedLaplace(space, isGiven, smallLeaves()).solve(exact);
  test::Largest error;
  for (int e = 0; e < mesh.size(); ++e) {
    const auto take = [&](Index i, double size) {
      error.take(size * (found[at(i)] - exact[at(i)]));
    };
    for (int k = 0; k <= mesh[e].degree; ++k)
      take(potentialOf(space, e, k), 1);
    for (int i = 0; i < mesh[e].densities; ++i)
      take(flowOf(space, e, i), 2 * mesh[e].half);
  }
  return error.size();
}

// Of degree 2 on lines its Cauchy data are in the spaces.
TEUCHOS_UNIT_TEST(MixedLaplace, findsHarmonicPolynomials) {
  for (const CompressedSample& sample : compressedSamples()) {
    if (sample.mesh.hasArcs() || sample.mesh.outline().isAxisymmetric())
      continue;
    std::vector<bem::Piece> pieces;
    for (const bem::Element& element : sample.mesh.elements()) {
      pieces.push_back(element.piece);
      pieces.back().degree = std::max(pieces.back().degree, 2);
    }
    const bem::Mesh mesh(sample.mesh.sharedOutline(), pieces);
    for (const int first : {0, 1}) {  // one edge alone, or all but it
      std::vector<bool> isGiven;
      std::vector<bool> outside;
      for (const bem::Element& element : mesh.elements()) {
        isGiven.push_back((element.piece.edge == 0) == (first == 0));
        outside.push_back(mesh.outline().edge(element.piece.edge).loop == 0);
      }
      out << sample.name << ": ";
      TEST_COMPARE(errorOfMixed(mesh, isGiven), <, 1e-10);
      if (mesh.outline().loops() > 1)  // fluxes alone on all holes, on the outer loop
        TEST_COMPARE(errorOfMixed(mesh, outside), <, 1e-10);
      outside.flip();
      if (mesh.outline().loops() > 1)
        TEST_COMPARE(errorOfMixed(mesh, outside), <, 1e-10);
    }
  }
}

}  // namespace

}  // namespace epafi::reference
