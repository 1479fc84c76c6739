#include "drivers/run/Path.hpp"

#include "bem/base/Error.hpp"
#include "drivers/run/Solver.hpp"

#include <algorithm>
#include <utility>

namespace epafi::drivers {

namespace {

class Follower {
 public:
  Follower(const PathGround& ground, const std::vector<PathPoint>& earlier,
           PhaseTimer& timer)
      : ground_(ground), earlier_(earlier), timer_(timer), memory_(ground.atZero) {
    path_.start.assign(static_cast<std::size_t>(ground.space.displacements()), 0.0);
  }

  /// Up to a time; false where the path ends before it.
  bool goTo(double time) {
    row_ = {};
    row_.level = ground_.level;
    row_.step = static_cast<int>(path_.steps.size()) + 1;
    row_.t = time;
    row_.parts = 0;
    double step = time - now_;
    const double shortest = ground_.scene.history.shortest(step);
    while (now_ < time) {
      // rounding shall not leave a tiny last part
      const double next = now_ + step > time - 1e-9 * step ? time : now_ + step;
      if (solve(next))
        continue;
      step *= 0.5;
      if (step >= shortest)
        continue;
      path_.reason = bem::message(
          "step ", row_.step, " of the path ends at t = ", now_, ", before t = ", time,
          ", although it was halved down to ", 2 * step, ": ", path_.reason);
      break;
    }
    row_.converged = now_ == time;
    finish();
    return row_.converged;
  }

  Path& path() { return path_; }

 private:
  contact::Report& report() { return path_.report; }

  contact::ContactProblem problemAt(const contact::Conditions& conditions) const {
    return ground_.atZero.at({conditions, memory_.slip(), memory_.largestLoad()});
  }

  Solved solution(const contact::ContactProblem& problem) {
    return timer_.run(Phase::Newton, [&] {
      return solveStep(problem.numbers(), state_, ground_.scene.solver,
                       ground_.stiffness.algebra());
    });
  }

  // One step to a time; what it ends with is kept also where it fails.
  bool solve(double next) {
    Solved attempt;
    contact::Solution& solved = attempt.solution;
    const bool isKnown = path_.points.size() < earlier_.size();
    if (isKnown)
      next = earlier_[path_.points.size()].t;
    auto now = std::make_unique<PathStep>();
    now->conditions = ground_.scene.conditionsAt(next);
    now->problem =
        std::make_unique<const contact::ContactProblem>(problemAt(now->conditions));
    if (isKnown) {
      const PathPoint& point = earlier_[path_.points.size()];
      solved.state = point.state;
      solved.report.newtonIterations = point.newtonIterations;
      solved.report.coulombIterations = point.coulombIterations;
      solved.report.status = contact::Status::Converged;
    } else {
      attempt = solution(*now->problem);
    }
    row_.newtonIterations += solved.report.newtonIterations;
    report() = contact::joined(solved.report, report());
    path_.reason = attempt.reason;
    const bool converged = solved.report.converged();
    if (converged)
      state_ = solved.state;
    now->state = solved.state.multiplier.empty() ? state_ : std::move(solved.state);
    now->displacement = now->problem->displacement(now->state);
    if (converged) {
      ++row_.parts;
      memory_.add(*now->problem, now->state, now->displacement);
      path_.points.push_back({next, now->state, solved.report.newtonIterations,
                              solved.report.coulombIterations});
      now_ = next;
    }
    latest_ = std::move(now);
    return converged;
  }

  // The step asked for, with everything that follows from its state.
  void finish() {
    PathStep& step = *latest_;
    step.density = step.problem->density(step.state, step.displacement);
    step.frictionWork = memory_.frictionWork();
    const bem::Units& units = ground_.units;
    const double energy = units.stress * units.length * units.length;
    const double strain = step.problem->strainEnergy(step.state, step.displacement);
    const double stored = step.problem->storedEnergy(step.state, step.displacement);
    row_.energyStrain = energy * strain;
    row_.energyDissipated = energy * memory_.friction();
    row_.energyTrapezoidal = energy * memory_.trapezoidal();
    row_.energyOutside = energy * memory_.outside();
    row_.energyStabilisation = energy * (stored - strain);
    row_.energyError = energy * memory_.imbalance(stored);
    auto work =
        contact::frictionWorkOfContacts(step.problem->multiplier(), step.frictionWork);
    path_.steps.push_back(std::move(latest_));
    const contact::Solved solved = solvedStep(ground_, path_, path_.steps.size() - 1);
    for (const auto& [name, summary] : contact::summarizeContacts(solved))
      row_.contacts.push_back({name, summary, energy * work[name]});
    path_.steps.back()->row = row_;
  }

  const PathGround& ground_;
  const std::vector<PathPoint>& earlier_;
  PhaseTimer& timer_;
  contact::PathMemory memory_;
  Path path_;
  StepRow row_;
  std::unique_ptr<PathStep> latest_;
  contact::State state_;
  double now_ = 0;
};

}  // namespace

contact::Solved solvedStep(const PathGround& ground, const Path& path, std::size_t step) {
  const PathStep& at = *path.steps[step];
  contact::Solved solved{ground.space, ground.stiffness, *at.problem,    at.conditions,
                         ground.units, at.state,         at.displacement};
  solved.displacementBefore = &path.before(step);
  return solved;
}

Path followPath(const PathGround& ground, const std::vector<PathPoint>& earlier,
                PhaseTimer& timer, const std::function<void(const Path&)>& handOut) {
  Follower follower(ground, earlier, timer);
  for (const double time : ground.scene.history.times) {
    const bool reached = follower.goTo(time);
    handOut(follower.path());
    if (!reached)
      break;
  }
  return std::move(follower.path());
}

}  // namespace epafi::drivers
