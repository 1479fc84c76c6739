// Operators for Tpetra and Belos do what the dense algebra does.
#include "bem/tpetra/SymmetricOperator.hpp"

#include "bem/base/Error.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/tpetra/BelosSolver.hpp"
#include "bem/tpetra/DistributedRows.hpp"
#include "bem/tpetra/WholeVectorOperator.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::Vector;
using test::difference;
using test::differenceBelow;

const bem::Lame lame({1, 0.3, false});

double entry(Index i, Index j) {
  return std::sin(static_cast<double>(5 * i + 3 * j * j));
}

TEUCHOS_UNIT_TEST(SteklovPoincareOperator, appliesSToSeveralVectors) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const bem::Space space(reference::quickSamples().front().mesh);
  const bem::SteklovPoincare s(bem::assembleOperators(space, lame, algebra), algebra);
  const bem::SteklovPoincareOperator op(s, algebra);
  const Index n = space.displacements();
  const bem::Rows mine = algebra.myRows(n);
  Tpetra::MultiVector<> x(op.getDomainMap(), 3);
  Tpetra::MultiVector<> y(op.getRangeMap(), 3);
  {
    const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Index j = 0; j < 3; ++j)
      for (Index i = 0; i < mine.size(); ++i)
        view(i, j) = entry(mine.begin + i, j);
  }
  y.putScalar(2);
  op.apply(x, y, Teuchos::NO_TRANS, -3, 0.5);
  const auto view = y.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (Index j = 0; j < 3; ++j) {
    Vector u;
    for (Index i = 0; i < n; ++i)
      u.push_back(entry(i, j));
    const Vector force = s.apply(u);
    for (Index i = 0; i < mine.size(); ++i)
      TEST_COMPARE(std::abs(view(i, j) - (1 - 3 * force[mine.begin + i])), <,
                   1e-12 * test::largest(force));
  }
}

TEUCHOS_UNIT_TEST(WholeVectorOperator, appliesCompressedOperatorsAndTheirInverse) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const bem::Space space(reference::quickSamples().front().mesh);
  bem::Compression options;
  options.leafUnknowns = 20;
  const bem::CompressedOperators operators(space, lame, options, {}, algebra);
  const Index n = operators.size();
  bem::Restriction restriction;
  restriction.held.assign(bem::at(n), 0);
  std::fill_n(restriction.held.begin(), space.displacements(), 1);
  const bem::CompressedFactor factor(operators, restriction, {});
  Matrix x(n, 2);
  for (Index j = 0; j < 2; ++j)
    for (Index i = 0; i < n; ++i)
      x(i, j) = entry(i, j);
  const auto agrees = [&](const bem::WholeVectorOperator::Action& action) {
    const bem::WholeVectorOperator op(n, action, algebra);
    const bem::Rows mine = algebra.myRows(n);
    Tpetra::MultiVector<> in(op.getDomainMap(), 2);
    Tpetra::MultiVector<> result(op.getRangeMap(), 2);
    {
      const auto view = in.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < mine.size(); ++i)
          view(i, j) = x(mine.begin + i, j);
    }
    result.putScalar(2);
    TEST_THROW(op.apply(in, result, Teuchos::TRANS), std::logic_error);
    op.apply(in, result, Teuchos::NO_TRANS, -3, 0.5);
    const Matrix image = action(x);
    const auto view = result.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (Index j = 0; j < 2; ++j)
      for (Index i = 0; i < mine.size(); ++i)
        TEST_EQUALITY(view(i, j), -3 * image(mine.begin + i, j) + 0.5 * 2);
  };
  agrees([&](const Matrix& columns) { return operators.times(columns); });
  agrees([&](const Matrix& columns) { return factor.solve(columns, 0); });
}

TEUCHOS_UNIT_TEST(BelosSolver, givesTheOperatorThatCholeskyGives) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  const bem::BelosSolver solver(algebra, {});
  for (const reference::Sample& sample : reference::quickSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = {0, 1};
    const bem::SteklovPoincare direct(
        bem::assembleOperators(space, lame, algebra, elements), algebra);
    const bem::SteklovPoincare krylov(
        bem::assembleOperators(space, lame, algebra, elements), algebra, solver);
    Vector u;
    for (Index i = 0; i < space.displacements(); ++i)
      u.push_back(entry(i, 1));
    out << sample.name << ": ";
    const Matrix whole =
        algebra.replicate(direct.stiffness().unpacked(), space.displacements());
    TEST_COMPARE(differenceBelow(algebra, krylov.stiffness().unpacked(), whole), <,
                 1e-10);
    TEST_COMPARE(difference(krylov.density(u), direct.density(u)), <, 1e-10);
    const auto projected = bem::TractionForm::Projected;
    const auto rows = bem::tractionRows(space, lame, krylov, elements, projected);
    const auto all = bem::tractionRows(space, lame, direct, elements, projected);
    TEST_COMPARE(difference(algebra, rows->rows,
                            algebra.replicate(all->rows.copy(), space.displacements())),
                 <, 1e-10);
  }
}

// Positive on each rank's own block, so that only the iteration can see it.
TEUCHOS_UNIT_TEST(BelosSolver, refusesAnIndefiniteMatrix) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  if (algebra.processes() == 1)
    return;
  const Index n = 60;
  const bem::Rows mine = algebra.myRows(n);
  Matrix a(mine.size(), n);
  Matrix b(mine.size(), 2);
  for (Index i = 0; i < mine.size(); ++i) {
    a(i, mine.begin + i) = 1;
    if (mine.begin + i == n - 1)
      a(i, 0) = 4;
    b(i, 0) = entry(mine.begin + i, 1);
    b(i, 1) = mine.begin + i == 0 ? 1 : mine.begin + i == n - 1 ? -1 : 0;
  }
  TEST_THROW(bem::BelosSolver(algebra, {}).solve(std::move(a), b), bem::NumericalError);
}

TEUCHOS_UNIT_TEST(BelosSolver, saysThatItTakesTooLong) {
  const bem::TpetraAlgebra algebra = test::allRanks();
  if (algebra.processes() == 1)
    return;
  const bem::Space space(reference::quickSamples().front().mesh);
  bem::BelosOptions options;
  options.maximumIterations = 1;
  const bem::BelosSolver solver(algebra, options);
  TEST_THROW(
      bem::SteklovPoincare(bem::assembleOperators(space, lame, algebra), algebra, solver),
      bem::NumericalError);
}

}  // namespace

}  // namespace epafi
