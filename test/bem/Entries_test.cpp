// Entries of some elements are those of the matrices, and far ones of W accurate in
// themselves.
#include "bem/operators/Entries.hpp"

#include "bem/algebra/LapackAlgebra.hpp"
#include "bem/operators/Assembly.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::reference {

namespace {

using bem::Index;

const bem::LapackAlgebra algebra;
const bem::Lame lame({1, 0.3, false});

std::vector<Index> densitiesOf(const bem::Space& space,
                               const std::vector<int>& elements) {
  std::vector<Index> result;
  for (const int e : elements)
    for (int k = 0; k < 2 * space.mesh()[e].densities; ++k)
      result.push_back(space.density(e, 0, 0) + k);
  return result;
}

std::vector<Index> displacementsOf(const bem::Space& space,
                                   const std::vector<int>& elements) {
  std::vector<Index> result;
  for (const int e : elements)
    for (int k = 0; k < 2 * space.mesh()[e].degree; ++k)
      result.push_back(space.displacement(e, 0, 0) + k);
  return result;
}

/// The largest difference, over the largest entry of the matrix; symmetric ones by their
/// lower triangle.
double difference(const bem::Matrix& block, const std::vector<Index>& rows,
                  const std::vector<Index>& columns, const bem::Matrix& matrix,
                  bool isLower) {
  double size = 0;
  for (Index j = 0; j < matrix.columns(); ++j)
    for (Index i = isLower ? j : 0; i < matrix.rows(); ++i)
      size = std::max(size, std::abs(matrix(i, j)));
  double worst = 0;
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Index row = isLower ? std::max(rows[i], columns[j]) : rows[i];
      const Index column = isLower ? std::min(rows[i], columns[j]) : columns[j];
      const double error = std::abs(block(static_cast<Index>(i), static_cast<Index>(j)) -
                                    matrix(row, column));
      worst = error <= worst ? worst : error;
    }
  return worst / size;
}

bem::Mesh squareWithHoleMesh(int elementsPerEdge, const std::vector<int>& degrees) {
  const auto outline = squareWithHole();
  std::vector<Cuts> cuts;
  for (std::size_t edge = 0; edge < outline->edges().size(); ++edge) {
    cuts.push_back({static_cast<int>(edge), {}});
    for (int k = 1; k < elementsPerEdge; ++k)
      cuts.back().fractions.push_back(
          std::pow(static_cast<double>(k) / elementsPerEdge, 1.3));
  }
  return cutMesh(outline, cuts, degrees);
}

TEUCHOS_UNIT_TEST(Entries, areThoseOfTheMatrices) {
  bem::Mesh mixed = squareWithHoleMesh(6, {1, 1, 4, 2, 1, 7});
  std::vector<int> densities;
  for (const bem::Element& element : mixed.elements())
    densities.push_back(element.degree + (element.startNode % 3 == 0 ? 1 : 0));
  for (const bem::Mesh& mesh :
       {squareWithHoleMesh(7, {1}), mixed, mixed.withDensities(densities)}) {
    const bem::Space space(mesh);
    const bem::Operators all = bem::assembleOperators(space, lame, algebra);
    const int last = mesh.size() - 1;
    for (const auto& [tests, trials] :
         {std::pair<std::vector<int>, std::vector<int>>{{0, 1, 2}, {0, 1, 2}},
          {{5, 4, 20}, {21, 22, last}},
          {{0}, {last, 9, 10}},
          {{last, last - 1, 0}, {3}}}) {
      const bem::EntryBlocks some = bem::entries(space, lame, tests, trials);
      const auto rows = displacementsOf(space, tests);
      const auto columns = displacementsOf(space, trials);
      TEST_COMPARE(difference(some.singleLayer, densitiesOf(space, tests),
                              densitiesOf(space, trials), all.singleLayer, true),
                   <, 1e-13);
      TEST_COMPARE(difference(some.doubleLayer, densitiesOf(space, tests), columns,
                              all.doubleLayer, false),
                   <, 1e-13);
      TEST_COMPARE(difference(some.hypersingular, rows, columns, all.hypersingular, true),
                   <, 1e-13);
    }
  }
}

/// Small elements in two corners of a square, where W by parts has no digits left.
TEUCHOS_UNIT_TEST(Entries, ofFarHatsAreAccurateInThemselves) {
  const auto outline = std::make_shared<const bem::Outline>(
      polygon({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}));
  const Cuts graded = {0, {1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5}};
  std::vector<Cuts> cuts;
  for (int edge = 0; edge < 4; ++edge)
    cuts.push_back({edge, edge % 2 == 0 ? graded.fractions : std::vector<double>{0.5}});
  for (const int degree : {1, 2}) {
    const bem::Space space(cutMesh(outline, cuts, {degree}));
    const QuadOperators exact = quadOperators(space, lame);
    const bem::Operators byParts = bem::assembleOperators(space, lame, algebra);
    const std::vector<int> tests = {9, 10, 11, 12, 13};
    const std::vector<int> trials = {0, 1, 2, 3, 4};
    const bem::EntryBlocks some = bem::entries(space, lame, tests, trials);
    const auto rows = displacementsOf(space, tests);
    const auto columns = displacementsOf(space, trials);
    double worst = 0;
    double worstByParts = 0;
    for (std::size_t j = 0; j < columns.size(); j += 2)
      for (std::size_t i = 0; i < rows.size(); i += 2) {
        double size = 0;
        double error = 0;
        double errorByParts = 0;
        for (std::size_t a = 0; a < 2; ++a)
          for (std::size_t b = 0; b < 2; ++b) {
            const auto value = exact.hypersingular(rows[i + a], columns[j + b]);
            const auto off = [&](double x) {
              return std::abs(static_cast<double>(x - value));
            };
            size = std::max(size, std::abs(static_cast<double>(value)));
            error = std::max(error, off(some.hypersingular(static_cast<Index>(i + a),
                                                           static_cast<Index>(j + b))));
            errorByParts = std::max(
                errorByParts, off(byParts.hypersingular(rows[i + a], columns[j + b])));
          }
        worst = std::max(worst, error / size);
        worstByParts = std::max(worstByParts, errorByParts / size);
      }
    TEST_COMPARE(worst, <, 1e-11);
    TEST_COMPARE(worstByParts, >, 1e-8);
  }
}

}  // namespace

}  // namespace epafi::reference
