// What pairs of elements give tile by tile, against 33 digits, and sources in sums; the same by every
// instruction set that this processor has.
#include "Largest.hpp"
#include "bem/fields/BoundaryFields.hpp"
#include "bem/operators/TileWriter.hpp"
#include "bem/simd/Dispatch.hpp"
#include "reference/QuadOperators.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi::reference {

namespace {

using bem::Index;

const bem::Lame lame({1, 0.3, false});

enum class Part { All, Lower };

/// The largest difference over the largest entry.
double difference(const bem::Matrix& a, const QuadMatrix& b, Part part) {
  test::Largest difference;
  test::Largest size;
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = part == Part::Lower ? j : 0; i < a.rows(); ++i) {
      const auto exact = static_cast<double>(b(i, j));
      difference.take(a(i, j) - exact);
      size.take(exact);
    }
  return difference.size() / size.size();
}

/// Two loops; elements and degrees such that runs are full, mixed and short, and groups
/// begin within runs.
std::vector<Sample> samples() {
  const auto outline = squareWithHole();
  const auto edges = outline->edges().size();
  const auto mesh = [&](int elementsPerEdge, const std::vector<int>& degrees) {
    std::vector<Cuts> cuts;
    for (std::size_t edge = 0; edge < edges; ++edge) {
      cuts.push_back({static_cast<int>(edge), {}});
      const int count = elementsPerEdge + static_cast<int>(edge) % 3;
      for (int k = 1; k < count; ++k)
        cuts.back().fractions.push_back(std::pow(static_cast<double>(k) / count, 1.3));
    }
    return cutMesh(outline, cuts, degrees);
  };
  const bem::Mesh plain = mesh(4, {2});
  std::vector<int> densities;  // of a side, and of one element beside others
  for (const bem::Element& element : plain.elements())
    densities.push_back(element.piece.edge == 2 || element.piece.edge == 0 ? 3 : 2);
  densities.back() = 3;
  return {{"more densities", plain.withDensities(densities)},
          {"degree 1", mesh(7, {1})},
          {"degree 3", mesh(5, {3})},
          {"mixed degrees", mesh(6, {1, 1, 4, 2, 1, 7})},
          {"25 beside 1", mesh(5, {25, 1, 1, 1, 1})},
          {"1 beside high degrees", mesh(6, {1, 1, 1, 1, 1, 1, 1, 1, 1, 6, 5, 6})}};
}

TEUCHOS_UNIT_TEST(TileBlocks, giveTheMatricesHoweverTheyAreGrouped) {
  for (const Sample& sample : samples()) {
    const bem::Space space(sample.mesh);
    const bem::Operators tiles = bem::assembleOperators(space, lame);
    const QuadOperators exact = quadOperators(space, lame, 1e-16);
    out << sample.name << ", " << sample.mesh.size() << " elements: ";
    TEST_COMPARE(difference(tiles.singleLayer, exact.singleLayer, Part::Lower), <, 1e-13);
    TEST_COMPARE(difference(tiles.doubleLayer, exact.doubleLayer, Part::All), <, 1e-13);
    TEST_COMPARE(difference(tiles.hypersingular, exact.hypersingular, Part::Lower), <,
                 1e-13);
  }
}

/// V, K and W of nothing but negative zeros: adding a zero shows.
bem::Operators untouched(const bem::Space& space) {
  bem::Operators out{bem::Matrix(space.densities(), space.densities()),
                     bem::Matrix(space.densities(), space.displacements()),
                     bem::Matrix(space.displacements(), space.displacements())};
  for (bem::Matrix* matrix : {&out.singleLayer, &out.doubleLayer, &out.hypersingular})
    for (Index j = 0; j < matrix->columns(); ++j)
      std::fill_n(matrix->column(j), matrix->rows(), -0.0);
  return out;
}

/// Is a matrix as it was in all columns and rows but those from some on?
bool isUntouchedBefore(const bem::Matrix& matrix, Index row, Index column) {
  for (Index j = 0; j < matrix.columns(); ++j)
    for (Index i = 0; i < matrix.rows(); ++i)
      if ((i < row || j < column) && !(matrix(i, j) == 0 && std::signbit(matrix(i, j))))
        return false;
  return true;
}

/// What another thread may be writing.  The group begins with the second loop.
TEUCHOS_UNIT_TEST(TileWriter, leavesAloneWhatIsBeforeItsGroup) {
  for (const Sample& sample : samples()) {
    const bem::Space space(sample.mesh);
    const bem::ElementRuns runs(space.mesh());
    int group = 0;
    while (!runs[group].closesLoop)
      ++group;
    ++group;
    bem::Operators written = untouched(space);
    bem::GhostNodes ghosts(space, runs);
    bem::TileWriter writer(space, written, ghosts);
    const auto pairs = bem::elasticKernel(space.mesh().outline(), lame)->pairs(space);
    const int first = runs[group].first;
    for (int r = group; r < runs.size(); ++r) {
      writer.begin(runs[group], runs[r]);
      for (int f = first; f < runs[group].last; ++f) {
        pairs->evaluate(runs, f, r, {std::max(f, runs[r].first), runs[r].last});
        writer.add(*pairs);
      }
      writer.finish();
    }
    const Index density = space.density(first, 0, 0);
    const Index displacement = space.displacement(first, 0, 0);
    out << sample.name << ", from element " << first << ": ";
    TEST_COMPARE(first, >, 0);
    TEST_ASSERT(isUntouchedBefore(written.singleLayer, density, density));
    TEST_ASSERT(isUntouchedBefore(written.doubleLayer, density, displacement));
    TEST_ASSERT(isUntouchedBefore(written.hypersingular, displacement, displacement));
  }
}

/// All that blocks hold, column after column.
bem::Vector entries(const bem::PairColumns& blocks, int degree) {
  bem::Vector all;
  const auto append = [&](const double* column, int size) {
    all.insert(all.end(), column, column + size);
  };
  for (int c = 0; c < blocks.components(); ++c)
    for (int k = 0; k <= degree; ++k) {
      const auto [slopes, scale] = blocks.hypersingular(k, c);
      append(blocks.doubleLayer(k, c), blocks.densities());
      append(slopes, blocks.displacements());
      all.push_back(scale);
      if (k == degree)
        continue;
      append(blocks.singleLayer(k, c), blocks.densities());
      append(blocks.transposed(k, c), blocks.displacements());
    }
  return all;
}

TEUCHOS_UNIT_TEST(TileBlocks, areTheSameForEveryInstructionSet) {
  for (const Sample& sample : samples())
    for (const auto& kernel :
         {bem::elasticKernel(sample.mesh.outline(), lame), bem::laplaceKernel()}) {
      const bem::Space space(sample.mesh, kernel->components());
      const bem::ElementRuns runs(space.mesh());
      const auto pairs = kernel->pairs(space);
      const int degree = space.mesh()[0].degree;
      for (int r = 0; r < runs.size(); ++r) {
        const auto evaluated = [&](bem::InstructionSet set) {
          const bem::WithInstructionSet only(set);
          pairs->evaluate(runs, 0, r, {runs[r].first, runs[r].last});
          return entries(*pairs, degree);
        };
        const bem::Vector baseline = evaluated(bem::InstructionSet::Baseline);
        for (const bem::InstructionSet set : bem::instructionSets()) {
          const bem::Vector other = evaluated(set);
          TEST_COMPARE(test::relativeDifference(other, baseline), <, 1e-13);
        }
      }
    }
}

TEUCHOS_UNIT_TEST(InstructionSets, startWithTheBaselineAndEndWithTheLargest) {
  TEST_ASSERT(bem::instructionSets().front() == bem::InstructionSet::Baseline);
  TEST_ASSERT(bem::instructionSets().back() == bem::usedInstructionSet());
}

// Near and far sources of several states.
TEUCHOS_UNIT_TEST(InstructionSets, giveTheSameFields) {
  for (const Sample& sample : samples()) {
    const bem::Space space(sample.mesh);
    const auto any = [](Index size, double seed) {
      bem::Vector v;
      for (Index i = 0; i < size; ++i)
        v.push_back(std::sin(seed + 1.7 * static_cast<double>(i)));
      return v;
    };
    const bem::Vector u = any(space.displacements(), 0.3);
    const bem::Vector psi = any(space.densities(), 1.3);
    const bem::Vector other = any(space.densities(), 2.2);
    const auto fieldsBy = [&](bem::InstructionSet set) {
      const bem::WithInstructionSet only(set);
      const bem::BoundaryFields fields(space, lame, {{u, psi}, {u, other}});
      bem::Vector numbers;
      for (const auto& values : fields.on(0))
        for (const bem::BoundaryValue& value : values)
          numbers.insert(numbers.end(), {value.traction.x, value.traction.y,
                                         value.mismatch.x, value.mismatch.y});
      return numbers;
    };
    const bem::Vector baseline = fieldsBy(bem::InstructionSet::Baseline);
    for (const bem::InstructionSet set : bem::instructionSets())
      TEST_COMPARE(test::relativeDifference(fieldsBy(set), baseline), <, 1e-12);
  }
}

}  // namespace

}  // namespace epafi::reference
