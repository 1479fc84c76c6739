#include "drivers/run/Solver.hpp"

#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/KeptFactor.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/ContactSolver.hpp"
#include "drivers/run/Reasons.hpp"
#include "drivers/run/UnheldMotions.hpp"

namespace epafi::drivers {

namespace {

using bem::Vector;

/// By what the options are assembled to for the problem; `memory`: see contact::NoxNewton;
/// the timer's watch is told of long paths of pivots.
SolvedProblem solveFrom(const contact::State& start, const Scene& scene,
                        const contact::ContactSystem& system,
                        contact::FactorMemory* memory, PhaseTimer& timer) {
  const SolverOptions& options = scene.solver;
  const contact::Problem& problem = system.numbers();
  const contact::NoxNewton newton(options.nox, memory);
  const contact::ContactSolver fixed(newton, options.contact, [&](int pivots, int most) {
    timer.tell(bem::message(nameOf(Phase::Newton), ", complementary pivoting: ", pivots,
                            " of at most ", most, " changes"));
  });
  contact::Solution solution =
      problem.boundDependsOnPressure()
          ? contact::makeCoulomb(fixed, options.coulomb)->solve(problem, start)
          : fixed.solve(problem, start);
  const std::string reason = reasonOf(solution.report, scene);
  return {std::move(solution), reason};
}

/// What rank 0 makes of it, on all ranks; where D is not formed all of them have a part in
/// it, and take the same steps.
template <class Solve>
SolvedProblem onFirstRank(const contact::ContactSystem& system,
                          const bem::Processes& processes, const Solve& solve) {
  if (!system.numbers().flexibility.isFormed())
    return solve();
  SolvedProblem solved;
  contact::State& state = solved.solution.state;
  if (processes.rank() == 0)
    solved = solve();
  if (processes.count() == 1)
    return solved;
  state.multiplier = processes.broadcast(std::move(state.multiplier));
  state.rigid = processes.broadcast(std::move(state.rigid));
  contact::Report& report = solved.solution.report;
  const Vector numbers = processes.broadcast(
      {report.converged() ? 1.0 : 0.0, static_cast<double>(report.newtonIterations),
       static_cast<double>(report.coulombIterations), report.residual, report.tolerance});
  const Vector reason =
      processes.broadcast(Vector(solved.reason.begin(), solved.reason.end()));
  if (processes.rank() != 0) {
    report.status =
        numbers[0] == 1 ? contact::Status::Converged : contact::Status::NotConverged;
    report.newtonIterations = static_cast<int>(numbers[1]);
    report.coulombIterations = static_cast<int>(numbers[2]);
    report.residual = numbers[3];
    report.tolerance = numbers[4];
    solved.reason.assign(reason.begin(), reason.end());
  }
  return solved;
}

}  // namespace

SolvedProblem solve(const contact::ContactSystem& system, const BodySpaces& spaces,
                    const std::function<contact::State()>& start,
                    const contact::State& otherwise, const bem::Processes& processes,
                    PhaseTimer& timer) {
  const Scene& scene = spaces.scene();
  const bool onPath = static_cast<bool>(scene.history);
  const auto from = [&](const contact::State& state) -> SolvedProblem {
    // of this step only: a run that goes on behind it shall compute the same digits
    contact::FactorMemory memory;
    std::string reason;
    try {
      return solveFrom(state, scene, system, onPath ? &memory : nullptr, timer);
    } catch (const contact::NoBalance& error) {
      reason = withAdvice(error, unresisted(spaces, system));
    } catch (const bem::NumericalError& error) {
      reason = error.what();
    }
    if (!onPath)
      throw bem::NumericalError(reason);
    return {{}, reason};
  };
  return onFirstRank(system, processes, [&] {
    const contact::State first = start();
    SolvedProblem solved = from(first);
    if (!onPath)
      solved.reason += changingPlaces(solved.solution.report, system, spaces);
    if (solved.solution.report.converged() || first.multiplier == otherwise.multiplier)
      return solved;
    SolvedProblem again = from(otherwise);
    again.solution.report =
        contact::joined(std::move(again.solution.report), solved.solution.report);
    return again;
  });
}

}  // namespace epafi::drivers
