#include "drivers/run/Solver.hpp"

#include "contact/equation/Equilibrium.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/ContactSolver.hpp"
#include "drivers/run/Reasons.hpp"
#include "drivers/run/UnheldMotions.hpp"

#include <algorithm>
#include <iterator>

namespace epafi::drivers {

namespace {

using bem::Vector;

/// By what the options are assembled to for the problem; the timer's watch is told of long paths
/// of pivots.
SolvedProblem solveFrom(const contact::State& start, const Scene& scene,
                        const contact::ContactSystem& system, PhaseTimer& timer) {
  const SolverOptions& options = scene.solver;
  const contact::Problem& problem = system.numbers();
  const contact::NoxNewton newton(options.nox);
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

constexpr std::ptrdiff_t scalars = 5;

Vector packed(const SolvedProblem& solved) {
  const contact::Report& report = solved.solution.report;
  Vector numbers = {
      report.converged() ? 1.0 : 0.0, static_cast<double>(report.newtonIterations),
      static_cast<double>(report.coulombIterations), report.residual, report.tolerance};
  numbers.insert(numbers.end(), solved.reason.begin(), solved.reason.end());
  return numbers;
}

void unpack(const Vector& numbers, SolvedProblem& solved) {
  contact::Report& report = solved.solution.report;
  report.status =
      numbers[0] == 1 ? contact::Status::Converged : contact::Status::NotConverged;
  report.newtonIterations = static_cast<int>(numbers[1]);
  report.coulombIterations = static_cast<int>(numbers[2]);
  report.residual = numbers[3];
  report.tolerance = numbers[4];
  std::transform(numbers.begin() + scalars, numbers.end(),
                 std::back_inserter(solved.reason),
                 [](double c) { return static_cast<char>(c); });
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
  const Vector numbers = processes.broadcast(packed(solved));
  if (processes.rank() != 0)
    unpack(numbers, solved);
  return solved;
}

/// Does a side shear and not yield?  On short elements wear then lets it slip and wear on and on.
bool shearsBesideRigid(const contact::ContactSystem& system) {
  for (std::size_t b = 0; b < system.size(); ++b)
    for (const auto& [boundary, contact] :
         system.body(b).multiplier().conditions().contact)
      if (contact.wear && contact.friction.compliance && !contact.normal)
        return true;
  return false;
}

}  // namespace

SolvedProblem settled(
    contact::ContactSystem& system, const contact::State* start,
    const std::function<SolvedProblem(const contact::State*)>& solveFrom,
    const bem::Processes& processes) {
  constexpr double same = 1e-12;
  constexpr double almost = 1e-8;  // where rounding changes it on and on
  constexpr int most = 400;        // a shear compliance alone may leave 3/4 of a change
  SolvedProblem solved = solveFrom(start);
  double last = 1;
  for (int k = 0; solved.solution.report.converged(); ++k) {
    const contact::Configuration at = system.configuration(solved.solution.state);
    const double reaction = system.reactionChange(at);
    const double wear = system.wearsBySlip() ? system.wearBy(at) : 0;
    const double change = std::max(reaction, wear);
    if (processes.agreed(change <= same || (change < almost && change > last / 2)))
      break;
    if (k == most) {
      solved.solution.report.status = contact::Status::NotConverged;
      solved.reason = bem::message(
          "what wears and the slip that it wears by do not settle, the last change is ",
          change, "; shorten Wear->Cycle Jump",
          shearsBesideRigid(system) ? ", or give Normal->Compliance beside "
                                      "Friction->Compliance"
                                    : "");
      break;
    }
    last = change;
    if (processes.agreed(reaction > 0))
      system.reactBy(at);
    SolvedProblem next = solveFrom(&solved.solution.state);
    next.solution.report =
        contact::joined(std::move(next.solution.report), solved.solution.report);
    solved = std::move(next);
  }
  return solved;
}

SolvedProblem solve(const contact::ContactSystem& system, const BodySpaces& spaces,
                    const contact::State& start, const bem::Processes& processes,
                    PhaseTimer& timer) {
  return onFirstRank(system, processes, [&]() -> SolvedProblem {
    try {
      SolvedProblem solved = solveFrom(start, spaces.scene(), system, timer);
      solved.reason += changingPlaces(solved.solution.report, system, spaces);
      return solved;
    } catch (const contact::NoBalance& error) {
      throw bem::NumericalError(withAdvice(error, unresisted(spaces, system)));
    }
  });
}

SolvedProblem solveStep(const contact::ContactSystem& system, const BodySpaces& spaces,
                        const contact::Prediction& prediction,
                        const contact::State* better, const bem::Processes& processes,
                        PhaseTimer& timer) {
  const auto from = [&](const contact::State& start) -> SolvedProblem {
    try {
      return solveFrom(start, spaces.scene(), system, timer);
    } catch (const contact::NoBalance& error) {
      return {{}, withAdvice(error, unresisted(spaces, system))};
    } catch (const bem::NumericalError& error) {
      return {{}, error.what()};
    }
  };
  return onFirstRank(system, processes, [&] {
    const contact::State start = better != nullptr ? *better : prediction.start(system);
    SolvedProblem solved = from(start);
    if (solved.solution.report.converged() ||
        start.multiplier == prediction.last().multiplier)
      return solved;
    SolvedProblem again = from(prediction.last());
    again.solution.report =
        contact::joined(std::move(again.solution.report), solved.solution.report);
    return again;
  });
}

}  // namespace epafi::drivers
