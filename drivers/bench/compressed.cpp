// A compressed system by its own factor, and by GMRES with the factor of a coarser one:
//
//   mpirun -n 1 build/bin/bench_compressed [ELEMENTS [TOLERANCE...]]
//
// A square, p = 1, its lower side held, sheared to and fro.  A line for each tolerance: CPU seconds of
// compression and factor, steps of Belos' GMRES on the system of 1e-12 to a residual of 1e-12, their
// seconds, and the difference to the solution by the factor of 1e-12, refined.
#include "bem/compressed/CompressedFactor.hpp"
#include "bem/tpetra/WholeVectorOperator.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockGmresSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Tpetra_Core.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::WholeVectorOperator;
using MultiVector = Tpetra::MultiVector<>;

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bem::Space square(int elements) {
  const bem::Loop loop{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                       {"bottom", "right", "top", "left"}};
  const int each = elements / 4;
  return bem::Space(bem::makeMesh(std::make_shared<const bem::Outline>(loop),
                                  {each, each, each, each}, 1));
}

/// The system, its factor, and what they cost.
struct System {
  double start = cpuSeconds();
  bem::CompressedOperators operators;
  double compressed = cpuSeconds();
  bem::CompressedFactor factor;
  double end = cpuSeconds();

  System(const bem::Space& space, const bem::Lame& lame, double tolerance,
         const bem::Restriction& restriction, const bem::MpiProcesses& processes)
      : operators(space, lame, with(tolerance), {}, processes),
        factor(operators, restriction, {}) {}

 private:
  static bem::Compression with(double tolerance) {
    bem::Compression options;
    options.tolerance = tolerance;
    return options;
  }
};

bem::Restriction lowerSideHeld(const bem::Space& space) {
  bem::Restriction restriction;
  restriction.held.resize(bem::at(space.displacements() + space.densities()));
  for (const int e : space.mesh().elementsOf("bottom"))
    for (const int k : {0, 1})
      for (const int component : {0, 1})
        restriction.held[bem::at(space.displacement(e, k, component))] = 1;
  return restriction;
}

/// With what is held as the identity's.
Matrix restricted(const bem::CompressedOperators& operators,
                  const std::vector<char>& held, const Matrix& x) {
  Matrix free = x.copy();
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      if (held[bem::at(i)] != 0)
        free(i, j) = 0;
  Matrix image = operators.times(free);
  for (Index j = 0; j < x.columns(); ++j)
    for (Index i = 0; i < x.rows(); ++i)
      if (held[bem::at(i)] != 0)
        image(i, j) = x(i, j);
  return image;
}

struct Solved {
  int steps = 0;
  double seconds = 0;
  Matrix x;
};

/// By Belos' GMRES on `system`, preconditioned by `coarse`.
Solved byGmres(const System& system, const System& coarse, const std::vector<char>& held,
               const Matrix& right, const bem::MpiProcesses& processes) {
  using Operator = Tpetra::Operator<>;
  using Problem = Belos::LinearProblem<double, MultiVector, Operator>;
  const double start = cpuSeconds();
  const Index n = right.rows();
  const auto matrix = Teuchos::rcp(new WholeVectorOperator(
      n, [&](const Matrix& x) { return restricted(system.operators, held, x); },
      processes));
  const auto inverse = Teuchos::rcp(new WholeVectorOperator(
      n, [&](const Matrix& x) { return coarse.factor.solve(x, 0); }, processes));
  const auto x = Teuchos::rcp(new MultiVector(matrix->getDomainMap(), 1));
  const auto b = Teuchos::rcp(new MultiVector(matrix->getDomainMap(), 1));
  {
    const auto view = b->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = right(b->getMap()->getGlobalElement(bem::asInt(i)), 0);
  }
  const auto problem = Teuchos::rcp(new Problem(matrix, x, b));
  problem->setRightPrec(inverse);
  problem->setProblem();
  const auto list = Teuchos::parameterList();
  list->set("Convergence Tolerance", 1e-12);
  list->set("Maximum Iterations", 200);
  Belos::PseudoBlockGmresSolMgr<double, MultiVector, Operator> manager(problem, list);
  manager.solve();
  return {manager.getNumIters(), cpuSeconds() - start, matrix->whole(*x)};
}

double difference(const Matrix& a, const Matrix& b) {
  double most = 0;
  double size = 0;
  for (Index i = 0; i < a.rows(); ++i) {
    most = std::max(most, std::abs(a(i, 0) - b(i, 0)));
    size = std::max(size, std::abs(b(i, 0)));
  }
  return most / size;
}

void measure(int elements, const std::vector<double>& tolerances,
             const bem::MpiProcesses& processes) {
  const bem::Lame lame({1, 0.3, false});
  const bem::Space space = square(elements);
  const bem::Restriction restriction = lowerSideHeld(space);
  const System fine(space, lame, 1e-12, restriction, processes);
  Matrix right(fine.operators.size(), 1);
  for (Index i = 0; i < space.displacements(); ++i)
    if (restriction.held[bem::at(i)] == 0)
      right(i, 0) = std::sin(static_cast<double>(i) / elements);
  const double start = cpuSeconds();
  const Matrix exact = fine.factor.solve(right, 1);
  const auto say = [&](double tolerance, const System& system, int steps, double seconds,
                       double error) {
    if (processes.rank() == 0)
      std::printf("| %.0e | %.2f | %.2f | %d | %.2f | %.0e |\n", tolerance,
                  system.compressed - system.start, system.end - system.compressed, steps,
                  seconds, error);
  };
  if (processes.rank() == 0)
    std::printf(
        "| %d elements | compression | factor | steps | solution | difference "
        "|\n|---|---|---|---|---|---|\n",
        elements);
  say(1e-12, fine, 0, cpuSeconds() - start, 0);
  for (const double tolerance : tolerances) {
    const System coarse(space, lame, tolerance, restriction, processes);
    const Solved solved = byGmres(fine, coarse, restriction.held, right, processes);
    say(tolerance, coarse, solved.steps, solved.seconds, difference(solved.x, exact));
  }
}

}  // namespace

}  // namespace epafi

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard tpetra(&argc, &argv);
  const int elements = argc > 1 ? std::atoi(argv[1]) : 4096;
  std::vector<double> tolerances;
  for (int i = 2; i < argc; ++i)
    tolerances.push_back(std::atof(argv[i]));
  if (tolerances.empty())
    tolerances = {1e-8, 1e-6, 1e-4};
  const epafi::bem::MpiProcesses processes(Tpetra::getDefaultComm());
  epafi::measure(elements, tolerances, processes);
}
