// The rows that several ranks assemble are those of one process.
#include "bem/tpetra/DistributedRows.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <numeric>

namespace epafi {

namespace {

using bem::Index;
using bem::Vector;
using test::difference;
using test::differenceBelow;

const bem::LapackAlgebra lapack;
const bem::Lame lame({1, 0.3, false});

std::vector<int> allElements(const bem::Mesh& mesh) {
  std::vector<int> elements(mesh.size());
  std::iota(elements.begin(), elements.end(), 0);
  return elements;
}

Vector somewhatRandom(Index n) {
  Vector v;
  v.reserve(n);
  for (Index i = 0; i < n; ++i)
    v.push_back(std::sin(static_cast<double>(3 * i * i + 1)));
  return v;
}

TEUCHOS_UNIT_TEST(DistributedOperators, haveTheSameBitsAsOnOneProcess) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const reference::Sample& sample : reference::hardSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = allElements(sample.mesh);
    const auto whole = bem::assembleOperators(space, lame, lapack, elements);
    const auto mine = bem::assembleOperators(space, lame, algebra, elements);
    out << sample.name << ": ";
    TEST_EQUALITY_CONST(differenceBelow(algebra, mine.singleLayer, whole.singleLayer), 0);
    TEST_EQUALITY_CONST(difference(algebra, mine.doubleLayer, whole.doubleLayer), 0);
    TEST_EQUALITY_CONST(differenceBelow(algebra, mine.hypersingular, whole.hypersingular),
                        0);
    TEST_EQUALITY_CONST(
        difference(algebra, mine.tractions.hypersingular, whole.tractions.hypersingular),
        0);
    TEST_EQUALITY_CONST(
        difference(algebra, mine.tractions.adjoint, whole.tractions.adjoint), 0);
  }
}

TEUCHOS_UNIT_TEST(DistributedOperators, giveTheSameSteklovPoincareOperator) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const reference::Sample& sample : reference::hardSamples()) {
    const bem::Space space(sample.mesh);
    const bem::SteklovPoincare whole(bem::assembleOperators(space, lame, lapack), lapack);
    const bem::SteklovPoincare mine(bem::assembleOperators(space, lame, algebra),
                                    algebra);
    const Vector u = somewhatRandom(space.displacements());
    out << sample.name << ": ";
    TEST_COMPARE(differenceBelow(algebra, mine.stiffness().unpacked(),
                                 whole.stiffness().unpacked()),
                 <, 1e-12);
    TEST_COMPARE(difference(mine.apply(u), whole.apply(u)), <, 1e-12);
    TEST_COMPARE(difference(mine.density(u), whole.density(u)), <, 1e-12);
  }
}

TEUCHOS_UNIT_TEST(DistributedOperators, giveTheSameTractions) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  for (const reference::Sample& sample : reference::quickSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = {0, 2, sample.mesh.size() - 1};
    const bem::SteklovPoincare whole(
        bem::assembleOperators(space, lame, lapack, elements), lapack);
    const bem::SteklovPoincare mine(
        bem::assembleOperators(space, lame, algebra, elements), algebra);
    for (const auto form : {bem::TractionForm::Projected, bem::TractionForm::Exact}) {
      const auto rows = bem::tractionRows(space, lame, mine, elements, form);
      const auto all = bem::tractionRows(space, lame, whole, elements, form);
      out << sample.name << ": ";
      TEST_COMPARE_ARRAYS(rows->start, all->start);
      TEST_COMPARE(difference(algebra, rows->rows, all->rows), <, 1e-12);
    }
  }
}

}  // namespace

}  // namespace epafi
