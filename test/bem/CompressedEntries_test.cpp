// Entries of the compressed system are those of the operators, and far ones of W accurate in
// themselves.
#include "CompressedSamples.hpp"
#include "Largest.hpp"
#include "bem/algebra/Products.hpp"
#include "bem/compressed/ProxyRows.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/QuadRings.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace epafi::reference {

namespace {

using bem::Index;
using bem::Matrix;
using test::largest;

TEUCHOS_UNIT_TEST(CompressedEntries, areThoseOfTheOperators) {
  for (const CompressedSample& sample : compressedSamples())
    for (const auto& kernel : kernelsOf(sample)) {
      const bem::Space space(sample.mesh, kernel->components());
      const Matrix z = wholeSystem(space, *kernel);
      // V and W by their lower triangles
      const bem::Operators all = bem::assemblePolynomialOperators(space, *kernel);
      const Index n = space.displacements();
      double v = 0;
      double k = 0;
      double w = 0;
      double skew = 0;
      for (Index j = 0; j < z.columns(); ++j)
        for (Index i = 0; i < z.rows(); ++i) {
          skew = std::max(skew, std::abs(z(i, j) - z(j, i)));
          if (i >= j && i < n)
            w = std::max(w, std::abs(z(i, j) - all.hypersingular(i, j)));
          else if (i >= j && j >= n)
            v = std::max(v, std::abs(z(i, j) + all.singleLayer(i - n, j - n)));
          else if (i >= n && j < n)
            k = std::max(k, std::abs(z(i, j) - all.doubleLayer(i - n, j)));
        }
      out << sample.name << ", " << kernel->components() << " components: V "
          << v / largest(all.singleLayer) << ", K " << k / largest(all.doubleLayer)
          << ", W " << w / largest(all.hypersingular) << "\n";
      TEST_COMPARE(v, <, 1e-12 * largest(all.singleLayer));
      TEST_COMPARE(k, <, 1e-12 * largest(all.doubleLayer));
      TEST_COMPARE(w, <, 1e-12 * largest(all.hypersingular));
      TEST_COMPARE(skew, <, 1e-12 * largest(z));
    }
}

/// Small elements in two corners of a square, where W by parts has no digits left.
TEUCHOS_UNIT_TEST(CompressedEntries, ofFarHatsAreAccurateInThemselves) {
  const std::vector<double> fractions = {1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5};
  std::vector<Cuts> cuts;
  for (int edge = 0; edge < 4; ++edge)
    cuts.push_back({edge, edge % 2 == 0 ? fractions : std::vector<double>{0.5}});
  const bem::Lame lame({1, 0.3, false});
  for (const int degree : {1, 2}) {
    const bem::Space space(cutMesh(outlineOf(square()), cuts, {degree}));
    const QuadOperators exact = quadOperators(space, lame);
    const bem::Operators byParts = bem::assembleOperators(space, lame);
    const Matrix z = wholeSystem(space, lame);
    double worst = 0;
    double worstByParts = 0;
    const auto from = [&](int e) { return space.displacement(e, 0, 0); };
    for (Index j = from(0); j < from(5); j += 2)
      for (Index i = from(9); i < from(14); i += 2) {
        double size = 0;
        double error = 0;
        double errorByParts = 0;
        for (const Index row : {i, i + 1})
          for (const Index column : {j, j + 1}) {
            const auto value = exact.hypersingular(row, column);
            const auto off = [&](double x) {
              return std::abs(static_cast<double>(x - value));
            };
            size = std::max(size, std::abs(static_cast<double>(value)));
            error = std::max(error, off(z(row, column)));
            errorByParts =
                std::max(errorByParts, off(byParts.hypersingular(row, column)));
          }
        worst = std::max(worst, error / size);
        worstByParts = std::max(worstByParts, errorByParts / size);
      }
    TEST_COMPARE(worst, <, 1e-11);
    TEST_COMPARE(worstByParts, >, 1e-8);
  }
}

/// Around an axis likewise, up to rounding over the distance from it; bubbles, since W by parts needs
/// no node for them.
TEUCHOS_UNIT_TEST(CompressedEntries, ofFarRingsAreAccurateInThemselves) {
  const bem::Lame lame({1, 0.3, false});
  const bem::Loop loop = polygon({{0, 1}, {0, 0}, {1, 0.3}, {1.2, 1.2}});
  const auto outline = std::make_shared<const bem::Outline>(
      loop, std::vector<bem::Loop>{}, bem::scalingOf(loop, true));
  const std::vector<double> fractions = {1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5};
  const bem::Space space(
      cutMesh(outline, {{1, fractions}, {2, {0.5}}, {3, fractions}}, {2}));
  const Matrix z = wholeSystem(space, lame);
  double worst = 0;
  const auto compare = [&](const QuadBlock& exact, int k, Index row, Index column,
                           double sign, double radius) {
    double size = 0;
    double error = 0;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) {
        const auto value = static_cast<double>(exact(2 * k + c, 2 * k + d));
        size = std::max(size, std::abs(value));
        error = std::max(error, std::abs(sign * z(row + c, column + d) - value));
      }
    worst = std::max(worst, error * radius / size);
  };
  // at the axis and in the corner opposite to it
  for (const int e : {1, 2, 3})
    for (const int f : {10, 11, 12}) {
      const QuadRings exact = quadRings(space.mesh(), e, f, lame, 1e-20);
      const Index n = space.displacements();
      compare(exact.singleLayer, 0, n + space.density(e, 0, 0),
              n + space.density(f, 0, 0), -1, 1);
      compare(exact.hypersingular, 2, space.displacement(e, 2, 0),
              space.displacement(f, 2, 0), 1, space.mesh().scaledPoint(e, 0).x);
    }
  TEST_COMPARE(worst, <, 1e-14);
}

/// What the coupled system makes of rigid motions: the largest force on a displacement, the largest
/// mean of a density over its element's half length.
std::pair<double, double> leftOfRigidMotions(const bem::Space& space) {
  const Matrix z = wholeSystem(space, bem::Lame({1, 0.3, false}));
  const Matrix rigid = space.rigidMotions();
  Matrix motions(z.columns(), rigid.columns());
  for (Index j = 0; j < rigid.columns(); ++j)
    std::copy_n(rigid.column(j), rigid.rows(), motions.column(j));
  const Matrix left = bem::product(z, motions);
  double forces = 0;
  double means = 0;
  const std::vector<bem::Unknown> unknowns = bem::unknownsOf(space);
  for (Index j = 0; j < left.columns(); ++j)
    for (Index i = 0; i < left.rows(); ++i) {
      const double size = std::abs(left(i, j));
      if (i < space.displacements())
        forces = std::max(forces, size);
      else
        means = std::max(means, size / space.mesh()[unknowns[i].element].half);
    }
  return {forces, means};
}

// Of pairs whose gap is the limit between near and far rounding decides.  Whatever it says, both
// elements of a hat must be taken alike, also those where the loop closes.
TEUCHOS_UNIT_TEST(CompressedEntries, leaveRigidMotionsWithoutTractions) {
  // the gap between the first element and the third is half of that
  const std::vector<double> fractions = {0.003125, 0.00625, 0.0125, 0.25,
                                         0.5,      0.75,    0.9875, 0.996875};
  double worst = 0;
  for (int k = 1; k <= 64; ++k) {
    const double height = 0.6 + 0.01 * k;
    const auto outline = outlineOf(polygon({{0, 0}, {1, 0}, {1, height}, {0, height}}));
    const bem::Space space(cutMesh(
        outline, {{0, fractions}, {1, fractions}, {2, fractions}, {3, fractions}}, {1}));
    const auto [forces, means] = leftOfRigidMotions(space);
    worst = std::max({worst, forces, means});
  }
  TEST_COMPARE(worst, <, 1e-11);
}

/// A side of 1 whose own edges get as short as 1e-8 of it towards its corners: places on edges that do
/// not touch must be as far from each other as the user's coordinates say.
std::vector<bem::Vec2> cornersOfShortEdges() {
  const std::vector<bem::Vec2> corners = {{-0.5, 0}, {0.5, 0}, {0.5, 0.75}, {-0.5, 0.75}};
  std::vector<bem::Vec2> vertices;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const bem::Vec2 a = corners[k];
    const bem::Vec2 side = corners[(k + 1) % corners.size()] - a;
    vertices.push_back(a);
    for (double share = std::ldexp(1, -27); share < 0.5; share *= 2)
      vertices.push_back(a + share * side);
    for (double share = 0.5; share > 1e-8; share /= 2)
      vertices.push_back(a + (1 - share) * side);
  }
  return vertices;
}

/// Edges of 1e-12 of the body whose middles have four digits left as coordinates, so long that two of
/// five are as far as elements must be that are not near, but for a little: that pair, and the near one
/// inside it, must be told apart.
std::vector<bem::Vec2> cornersOfTinyEdges() {
  constexpr double length = 1e-12;
  std::vector<double> places = {0};
  for (int k = 0; k < 60; ++k)
    places.push_back(places.back() - (k % 3 == 2 ? 0.499995 : 1) * length);
  std::vector<bem::Vec2> vertices;
  for (std::size_t k = places.size(); k-- > 0;)
    vertices.push_back({places[k], 0});
  vertices.insert(vertices.end(), {{0.6, 0}, {0.6, 0.8}, {-0.2, 0.8}});
  return vertices;
}

TEUCHOS_UNIT_TEST(CompressedEntries, ofShortEdgesLeaveRigidMotionsWithoutTractions) {
  for (const auto& [vertices, elements] :
       {std::pair(cornersOfShortEdges(), 2), {cornersOfTinyEdges(), 1}}) {
    const auto [forces, means] =
        leftOfRigidMotions(bem::Space(meshOf(polygon(vertices), elements, 1)));
    TEST_COMPARE(forces, <, 1e-13);
    TEST_COMPARE(means, <, 1e-13);
  }
}

// K of a translation vanishes outside, however few points a body that is far away takes.
TEUCHOS_UNIT_TEST(CompressedEntries, translatedDiscsHaveNoFieldOnCirclesAround) {
  const bem::Lame lame({1, 0.3, false});
  for (const int arcs : {2, 3, 4, 12}) {
    const bem::Space space(
        bem::makeMesh(outlineOf(disc(arcs, 0.5)), std::vector<int>(arcs, 1), 1));
    const auto kernel = bem::elasticKernel(space.mesh().outline(), lame);
    const bem::ClusterTree tree(space, 1000);
    const std::vector<bem::Unknown> unknowns = bem::unknownsOf(space);
    std::vector<Index> nodes(space.displacements());
    std::iota(nodes.begin(), nodes.end(), 0);
    for (const double ratio : {2.0, 10.0, 100.0}) {
      bem::ProxyRows fields(space, *kernel, unknowns, ratio, 1e-12);
      const Matrix k = fields(tree, 0, nodes);
      Matrix field = bem::product(k, space.rigidMotions());
      field.shrink(2);  // rotations are no polynomials on arcs
      out << arcs << " arcs, circle of " << ratio << " radii: ";
      TEST_COMPARE(largest(field), <, 1e-12 * largest(k));
    }
  }
}

}  // namespace

}  // namespace epafi::reference
