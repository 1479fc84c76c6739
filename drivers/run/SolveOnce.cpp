#include "drivers/run/SolveOnce.hpp"

#include "contact/coulomb/LoadContinuation.hpp"
#include "drivers/run/Restless.hpp"

#include <algorithm>
#include <iterator>

namespace epafi::drivers {

namespace {

using bem::Vector;

constexpr std::ptrdiff_t scalars = 6;

Vector packed(const contact::Report& report) {
  Vector numbers = {report.status == contact::Status::Converged ? 1.0 : 0.0,
                    static_cast<double>(report.newtonIterations),
                    static_cast<double>(report.coulombIterations),
                    report.residual,
                    report.tolerance,
                    report.globalised ? 1.0 : 0.0};
  numbers.insert(numbers.end(), report.reason.begin(), report.reason.end());
  return numbers;
}

contact::Report unpacked(const Vector& numbers) {
  contact::Report report;
  report.status =
      numbers[0] == 1 ? contact::Status::Converged : contact::Status::NotConverged;
  report.newtonIterations = static_cast<int>(numbers[1]);
  report.coulombIterations = static_cast<int>(numbers[2]);
  report.residual = numbers[3];
  report.tolerance = numbers[4];
  report.globalised = numbers[5] == 1;
  std::transform(numbers.begin() + scalars, numbers.end(),
                 std::back_inserter(report.reason),
                 [](double c) { return static_cast<char>(c); });
  return report;
}

}  // namespace

contact::Solution solveOnce(const contact::ContactProblem& problem, const bem::Mesh& mesh,
                            const contact::State& start,
                            const contact::SolverOptions& options,
                            const bem::DenseAlgebra& algebra) {
  contact::Solution solution;
  if (algebra.rank() == 0) {
    solution =
        contact::solveInLoadSteps(problem.numbers(), problem.gap(), start, options);
    solution.report.reason += restlessPlaces(solution.report, problem.multiplier(), mesh);
  }
  if (algebra.processes() == 1)
    return solution;
  solution.state.multiplier = algebra.broadcast(std::move(solution.state.multiplier));
  solution.state.rigid = algebra.broadcast(std::move(solution.state.rigid));
  const Vector report = algebra.broadcast(packed(solution.report));
  if (algebra.rank() != 0)
    solution.report = unpacked(report);
  return solution;
}

}  // namespace epafi::drivers
