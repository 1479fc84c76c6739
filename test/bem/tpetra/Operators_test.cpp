// Operators for Tpetra and Belos do what the operators on whole vectors do.
#include "Largest.hpp"
#include "bem/base/Error.hpp"
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/tpetra/BelosSolver.hpp"
#include "bem/tpetra/MpiProcesses.hpp"
#include "bem/tpetra/SteklovPoincareOperator.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>
#include <Tpetra_Core.hpp>

#include <numeric>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::Vector;
using test::relativeDifference;

const bem::Lame lame({1, 0.3, false});

double entry(Index i, Index j) {
  return std::sin(static_cast<double>(5 * i + 3 * j * j));
}

TEUCHOS_UNIT_TEST(SteklovPoincareOperator, appliesSToSeveralVectors) {
  const bem::MpiProcesses processes(Tpetra::getDefaultComm());
  const bem::Space space(reference::quickSamples().front().mesh);
  const bem::SteklovPoincare s(bem::assembleOperators(space, lame));
  const bem::SteklovPoincareOperator op(s, processes);
  const Index n = space.displacements();
  const auto map = op.getDomainMap();
  Tpetra::MultiVector<> x(op.getDomainMap(), 3);
  Tpetra::MultiVector<> y(op.getRangeMap(), 3);
  {
    const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Index j = 0; j < 3; ++j)
      for (int i = 0; i < static_cast<int>(view.extent(0)); ++i)
        view(i, j) = entry(map->getGlobalElement(i), j);
  }
  y.putScalar(2);
  op.apply(x, y, Teuchos::NO_TRANS, -3, 0.5);
  const auto view = y.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (Index j = 0; j < 3; ++j) {
    Vector u;
    for (Index i = 0; i < n; ++i)
      u.push_back(entry(i, j));
    const Vector force = s.apply(u);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      TEST_COMPARE(
          std::abs(view(i, j) - (1 - 3 * force[map->getGlobalElement(bem::asInt(i))])), <,
          1e-12 * test::largest(force));
  }
}

TEUCHOS_UNIT_TEST(WholeVectorOperator, appliesCompressedOperatorsAndTheirInverse) {
  const bem::MpiProcesses processes(Tpetra::getDefaultComm());
  const bem::Space space(reference::quickSamples().front().mesh);
  bem::Compression options;
  options.leafUnknowns = 20;
  const bem::CompressedOperators operators(space, lame, options, {}, processes);
  const Index n = operators.size();
  bem::Restriction restriction;
  restriction.held.assign(bem::at(n), 0);
  std::fill_n(restriction.held.begin(), space.displacements(), 1);
  const bem::CompressedFactor factor(operators, restriction);
  Matrix x(n, 2);
  for (Index j = 0; j < 2; ++j)
    for (Index i = 0; i < n; ++i)
      x(i, j) = entry(i, j);
  const auto agrees = [&](const bem::WholeVectorOperator::Action& action) {
    const bem::WholeVectorOperator op(n, action, processes);
    const auto map = op.getDomainMap();
    Tpetra::MultiVector<> in(op.getDomainMap(), 2);
    Tpetra::MultiVector<> result(op.getRangeMap(), 2);
    {
      const auto view = in.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (Index j = 0; j < 2; ++j)
        for (int i = 0; i < static_cast<int>(view.extent(0)); ++i)
          view(i, j) = x(map->getGlobalElement(i), j);
    }
    result.putScalar(2);
    TEST_THROW(op.apply(in, result, Teuchos::TRANS), std::logic_error);
    op.apply(in, result, Teuchos::NO_TRANS, -3, 0.5);
    const Matrix image = action(x);
    const auto view = result.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (Index j = 0; j < 2; ++j)
      for (std::size_t i = 0; i < view.extent(0); ++i)
        TEST_EQUALITY(view(i, j),
                      -3 * image(map->getGlobalElement(bem::asInt(i)), j) + 0.5 * 2);
  };
  agrees([&](const Matrix& columns) { return operators.times(columns); });
  agrees([&](const Matrix& columns) { return factor.solve(columns, 0); });
}

TEUCHOS_UNIT_TEST(BelosSolver, givesTheOperatorThatCholeskyGives) {
  const bem::MpiProcesses processes(Tpetra::getDefaultComm());
  const bem::BelosSolver solver(processes, {});
  for (const reference::Sample& sample : reference::quickSamples()) {
    const bem::Space space(sample.mesh);
    const std::vector<int> elements = {0, 1};
    const bem::SteklovPoincare direct(bem::assembleOperators(space, lame));
    const bem::SteklovPoincare krylov(bem::assembleOperators(space, lame), solver);
    Vector u;
    for (Index i = 0; i < space.displacements(); ++i)
      u.push_back(entry(i, 1));
    out << sample.name << ": ";
    std::vector<Index> columns(u.size());
    std::iota(columns.begin(), columns.end(), Index{0});
    const Vector stiffness = direct.stiffness().columns(columns);
    TEST_COMPARE(test::largestDifference(krylov.stiffness().columns(columns), stiffness),
                 <, 1e-10 * test::largest(stiffness));
    const Vector psi = direct.density(u);
    TEST_COMPARE(test::largestDifference(krylov.density(u), psi), <,
                 1e-10 * test::largest(psi));
    const auto projected = bem::TractionForm::Projected;
    const auto rows = bem::tractionRows(space, lame, krylov, elements, projected);
    const auto all = bem::tractionRows(space, lame, direct, elements, projected);
    TEST_COMPARE(relativeDifference(rows->rows, all->rows), <, 1e-10);
  }
}

// Positive on each rank's own block, so that only the iteration can see it.
TEUCHOS_UNIT_TEST(BelosSolver, refusesAnIndefiniteMatrix) {
  const bem::MpiProcesses processes(Tpetra::getDefaultComm());
  if (processes.count() == 1)
    return;
  const Index n = 60;
  Matrix a(n, n);
  Matrix b(n, 2);
  for (Index i = 0; i < n; ++i) {
    a(i, i) = 1;
    b(i, 0) = entry(i, 1);
  }
  a(n - 1, 0) = 4;
  b(0, 1) = 1;
  b(n - 1, 1) = -1;
  TEST_THROW(bem::BelosSolver(processes, {}).solve(std::move(a), b), bem::NumericalError);
}

TEUCHOS_UNIT_TEST(BelosSolver, saysThatItTakesTooLong) {
  const bem::MpiProcesses processes(Tpetra::getDefaultComm());
  if (processes.count() == 1)
    return;
  const bem::Space space(reference::quickSamples().front().mesh);
  bem::BelosOptions options;
  options.maximumIterations = 1;
  const bem::BelosSolver solver(processes, options);
  TEST_THROW(bem::SteklovPoincare(bem::assembleOperators(space, lame), solver),
             bem::NumericalError);
}

}  // namespace

}  // namespace epafi
