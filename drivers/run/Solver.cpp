#include "drivers/run/Solver.hpp"

#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "contact/nox/NoxNewton.hpp"
#include "contact/solve/ContactSolver.hpp"
#include "contact/solve/Report.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/UnheldMotions.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace epafi::drivers {

namespace {

using bem::message;
using bem::Vector;
using contact::End;
using contact::Report;
using contact::Stage;
using contact::StageRun;

// What an end asks for.
struct Advice {
  End end;
  const char* words;
};

constexpr Advice advices[] = {
    {End::Iterations, "raise Solver->Maximum Iterations"},
    {End::Cycling,
     "the active sets repeat; use another Multiplier, or a finer mesh where the contact "
     "ends"},
    {End::Growth, "the residual grows; check load and units, or load in steps"},
    {End::Stalled,
     "no step length decreases the merit function; the problem may be too "
     "ill-conditioned for this Solver->Tolerance, or have no solution"},
};

constexpr const char* holdTheMotion =
    "; hold the motion (Rigid Motions -> Fix or a Dirichlet condition; of a rigid body a "
    "Displacement or a Rotation), or change the load or the friction";

std::string ended(const Report& report, End end) {
  if (end == End::NoBalance)
    return report.failure.empty() ? message(contact::NoBalance().what(), holdTheMotion)
                                  : report.failure + holdTheMotion;
  const std::string residual =
      message("scaled residual ", report.residual, ", tolerance ", report.tolerance,
              " after ", report.newtonIterations, " steps");
  for (const Advice& advice : advices)
    if (advice.end == end)
      return residual + ": " + advice.words;
  return residual + ": " + report.failure;
}

/// Does a side slide with friction?
bool hasFriction(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    const auto& contacts = body.conditions.contact;
    return std::any_of(contacts.begin(), contacts.end(), [](const auto& contact) {
      return contact.second.friction.law != nullptr && !contact.second.ties();
    });
  });
}

std::string worded(const Report& report, const std::vector<StageRun>& stages,
                   bool hasFriction) {
  if (stages.empty())
    return report.failure;
  const StageRun& last = stages.back();
  if ((last.end == End::TooLarge || last.end == End::TooLong) && stages.size() > 1) {
    const auto before = std::find_if(
        stages.begin(), stages.end(),
        [](const StageRun& run) { return run.stage == Stage::FollowOffset; });
    return worded(report, {stages.begin(), before}, hasFriction) +
           ".  Complementary pivoting, which mostly solves what Newton's steps do not, "
           "was " +
           (last.end == End::TooLarge
                ? message("not tried: operators that are not dense allow it for up to ",
                          contact::ContactSolver::mostToPivot, " contact coefficients")
                : message("given up after ", contact::ContactSolverOptions().mostWork,
                          " operations: with so many contact coefficients it would take "
                          "hours")) +
           (hasFriction
                ? ".  Try a smaller friction coefficient, or a coarser mesh on the "
                  "sides in contact"
                : ".  Try a coarser mesh on the sides in contact");
  }
  if (last.stage == Stage::FollowOffset)
    return ended(report, last.end) +
           ".  Newton's method and complementary pivoting were tried.  " +
           (hasFriction
                ? "There is no solution where the load drives a body beyond what "
                  "friction "
                  "holds: hold the motion, or lessen the load; with a large friction "
                  "coefficient there may be several, or none: try a smaller one, or a "
                  "finer mesh"
                : "Without friction what is held has one solution: rounding has taken "
                  "the "
                  "digits of it, as it does where a bonded layer is thinner than 1 : "
                  "3000 "
                  "of its length, and a body more slender than 1 : 1000; give the layer "
                  "and what it is bonded to one outline, or look at units and the mesh");
  if (last.stage != Stage::FixedPoint || last.parts.empty())
    return ended(report, last.end);
  std::string text;
  if (last.end == End::Unsettled)
    text = message("the slip bound still changes by ", last.parts.back().residual,
                   " of the load after ", report.coulombIterations,
                   " updates: use Solver->Coulomb Iteration = 'Newton', or raise "
                   "Solver->Coulomb Maximum Iterations; with a large friction "
                   "coefficient there may be several solutions, or none");
  else
    text = message("Tresca's problem of an update of the slip bound: ",
                   worded(report, last.parts, hasFriction),
                   ".  Try Solver->Coulomb Iteration = 'Newton'");
  return text;
}

}  // namespace

std::string reasonOf(const Report& report, const Scene& scene) {
  if (report.converged())
    return "";
  const bool unstable = !scene.stabilization.isOn() &&
                        !contact::multiplierBasis(scene.multiplier).sharesNodes;
  return worded(report, report.stages, hasFriction(scene)) +
         (unstable ? message("; Discretization->Stabilization->Form = 'None' is stable "
                             "with Multiplier 'Biorthogonal' only, not with '",
                             scene.multiplier, "'")
                   : "");
}

namespace {

/// Message for a load that nothing balances, with the motion of unresisted() if there is
/// one, and advice.
std::string withAdvice(const contact::NoBalance& error, const std::string& unresisted) {
  return message(unresisted.empty() ? error.what() : unresisted, holdTheMotion);
}

/// "; contact points that still change state: (0.31, 0) on foundation, ...", at most
/// five; empty if there are none.
std::string changingPlaces(const contact::Report& report,
                           const contact::ContactSystem& system,
                           const BodySpaces& spaces) {
  constexpr std::size_t shown = 5;
  const std::set<contact::Index> changing(report.changing.begin(), report.changing.end());
  std::vector<std::string> places;
  const contact::MultiplierSpace& multiplier = system.multiplier();
  multiplier.forEachElement([&](const auto& element) {
    const Vector at = multiplier.basis().places(element.degree);
    for (int i = 0; i <= element.degree; ++i) {
      if (changing.count(element.normalOf(i)) == 0 &&
          (!element.shears() || changing.count(element.tangentialOf(i)) == 0))
        continue;
      const bem::Vec2 place = element.mesh->physicalPoint(element.element, at[i]);
      places.push_back(message("(", place.x, ", ", place.y, ") on ",
                               spaces.scene().boundaryName(
                                   {false, bem::at(element.body), *element.boundary})));
    }
  });
  std::string text;
  for (std::size_t k = 0; k < std::min(places.size(), shown); ++k)
    text += (k == 0 ? "; contact points that still change state: " : ", ") + places[k];
  if (places.size() > shown)
    text += message(" and ", places.size() - shown, " more");
  return text;
}

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

/// Does a side shear and not yield?  On short elements wear then lets it slip and wear on and on.
bool shearsBesideRigid(const contact::ContactSystem& system) {
  for (std::size_t b = 0; b < system.size(); ++b)
    for (const auto& [boundary, contact] : system.body(b).conditions().contact)
      if (contact.wear && contact.friction.compliance && !contact.normal)
        return true;
  return false;
}

}  // namespace

SettledProblem settled(
    contact::ContactSystem& system,
    const std::function<SolvedProblem(const contact::State*)>& solveFrom,
    const bem::Processes& processes) {
  SettledProblem result;
  static_cast<contact::Settled&>(result) = contact::settled(
      system,
      [&](const contact::State* before) {
        SolvedProblem solved = solveFrom(before);
        result.reason = std::move(solved.reason);
        return std::move(solved.solution);
      },
      processes);
  if (result.wearChange > 0)
    result.reason = message(
        "what wears and the slip that it wears by do not settle, the last change is ",
        result.wearChange, "; shorten Wear->Cycle Jump",
        shearsBesideRigid(system) ? ", or give Normal->Compliance beside "
                                    "Friction->Compliance"
                                  : "");
  return result;
}

SolvedProblem solve(const contact::ContactSystem& system, const BodySpaces& spaces,
                    const std::function<contact::State()>& start,
                    const contact::State& otherwise, const bem::Processes& processes,
                    PhaseTimer& timer) {
  const Scene& scene = spaces.scene();
  const bool onPath = static_cast<bool>(scene.history);
  const auto from = [&](const contact::State& state) -> SolvedProblem {
    std::string reason;
    try {
      SolvedProblem solved = solveFrom(state, scene, system, timer);
      if (!onPath)
        solved.reason += changingPlaces(solved.solution.report, system, spaces);
      return solved;
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
    if (solved.solution.report.converged() ||
        (first.multiplier == otherwise.multiplier && first.rigid == otherwise.rigid))
      return solved;
    SolvedProblem again;
    try {
      again = from(otherwise);
    } catch (const bem::NumericalError&) {
      return solved;  // which has a state
    }
    again.solution.report =
        contact::joined(std::move(again.solution.report), solved.solution.report);
    return again;
  });
}

}  // namespace epafi::drivers
