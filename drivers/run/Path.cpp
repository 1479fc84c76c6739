#include "drivers/run/Path.hpp"

#include "bem/base/Error.hpp"
#include "contact/solve/DefectCorrection.hpp"
#include "drivers/run/Solver.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace epafi::drivers {

namespace {

class Follower {
 public:
  Follower(const Ground& ground, const contact::ContactSystem& atZero,
           const std::vector<PathPoint>& earlier, PhaseTimer& timer)
      : ground_(ground),
        atZero_(atZero),
        earlier_(earlier),
        timer_(timer),
        memory_(atZero),
        prediction_(atZero),
        empty_(emptyRow(ground.scene, ground.spaces)) {
    std::vector<bem::Vector> still;
    for (std::size_t b = 0; b < atZero.size(); ++b)
      still.emplace_back(atZero.body(b).load().size());
    path_.start = std::make_unique<const Placement>(
        ground.spaces, std::move(still),
        std::vector<contact::RigidMotion>(ground.scene.rigid.size()));
  }

  /// Up to a time; false where the path ends before it.
  bool goTo(double time) {
    row_ = empty_;
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
    timer_.run(Phase::Results, [&] { finish(); });
    return row_.converged;
  }

  Path& path() { return path_; }

 private:
  contact::Report& report() { return path_.report; }

  // One step to a time; what it ends with is kept also where it fails.
  bool solve(double next) {
    SolvedProblem attempt;
    contact::Solution& solved = attempt.solution;
    const bool isKnown = path_.points.size() < earlier_.size();
    if (isKnown)
      next = earlier_[path_.points.size()].t;
    auto now = std::make_unique<PathStep>();
    timer_.run(Phase::Stabilization, [&] {
      now->conditions = ground_.scene.conditionsAt(next);
      now->system = std::make_unique<const contact::ContactSystem>(
          atZero_.under({now->conditions, ground_.scene.drivesAt(next), memory_.slip(),
                         memory_.defect(), memory_.largestLoad(), responses_}));
    });
    if (isKnown) {
      const PathPoint& point = earlier_[path_.points.size()];
      solved.state = point.state;
      solved.report.newtonIterations = point.newtonIterations;
      solved.report.coulombIterations = point.coulombIterations;
      solved.report.status = contact::Status::Converged;
    } else {
      attempt = timer_.run(Phase::Newton, [&] {
        return solveStep(ground_.scene, *now->system, ground_.spaces, prediction_,
                         ground_.stiffness.front().algebra(), timer_);
      });
    }
    row_.newtonIterations += solved.report.newtonIterations;
    report() = contact::joined(solved.report, report());
    path_.reason = attempt.reason;
    const bool converged = solved.report.converged();
    if (solved.state.multiplier.empty())
      solved.state = prediction_.last();
    timer_.run(Phase::Newton, [&] {
      latestAt_ = converged && !isKnown
                      ? contact::corrected(*now->system, solved.state,
                                           ground_.stiffness.front().algebra())
                      : now->system->configuration(solved.state);
      if (!converged)
        return;
      memory_.add(*now->system, latestAt_);
      prediction_.add(*now->system, latestAt_.state);
      responses_ = now->system->responses();
    });
    if (converged) {
      ++row_.parts;
      path_.points.push_back({next, latestAt_.state, solved.report.newtonIterations,
                              solved.report.coulombIterations});
      now_ = next;
    }
    latest_ = std::move(now);
    return converged;
  }

  // The step asked for, with everything that follows from its state.
  void finish() {
    const Placement& before =
        path_.steps.empty() ? *path_.start : path_.last().solved->placement();
    PathStep& step = *latest_;
    const contact::ContactSystem& system = *step.system;
    step.solved = std::make_unique<const SolvedBodies>(ground_, system, step.conditions,
                                                       std::move(latestAt_), &before);
    const contact::Configuration& at = step.solved->at();
    const bem::Units units = ground_.scene.units();
    const double energy = units.stress * units.length * units.length;
    const double strain = system.strainEnergy(at);
    const double stored = system.storedEnergy(at);
    row_.energyStrain = energy * strain;
    row_.energyDissipated = energy * memory_.friction();
    row_.energyTrapezoidal = energy * memory_.trapezoidal();
    row_.energyOutside = energy * memory_.outside();
    row_.energyStabilisation = energy * (stored - strain);
    row_.energyError = energy * memory_.imbalance(stored);
    row_.rigid = step.solved->rigidRows();
    auto contact = row_.contacts.begin();
    for (std::size_t b = 0; b < system.size(); ++b) {
      step.frictionWork.push_back(
          system.numbering().tangentialsOf(b, memory_.frictionWork()));
      auto work = contact::frictionWorkOfContacts(system.body(b).multiplier(),
                                                  step.frictionWork[b]);
      for (const auto& [name, summary] :
           contact::summarizeContacts(step.solved->bodies()[b])) {
        contact->summary = summary;
        contact->dissipated = energy * work[name];
        ++contact;
      }
    }
    if (ground_.scene.hasSeveral())
      row_.bodies = contact::summarizeAll(step.solved->bodies());
    step.row = row_;
    path_.steps.push_back(std::move(latest_));
  }

  const Ground& ground_;
  const contact::ContactSystem& atZero_;
  const std::vector<PathPoint>& earlier_;
  PhaseTimer& timer_;
  contact::PathMemory memory_;
  contact::Prediction prediction_;
  std::vector<contact::LoadResponses> responses_;
  Path path_;
  const StepRow empty_;
  StepRow row_;
  std::unique_ptr<PathStep> latest_;
  contact::Configuration latestAt_;
  double now_ = 0;
};

}  // namespace

StepRow emptyRow(const Scene& scene, const BodySpaces& spaces) {
  StepRow row;
  std::map<std::string, int> uses;  // of a name
  for (const RigidBody& body : scene.rigid) {
    row.rigid.push_back({body.name, body.pole, {}, {}, {}, {}});
    ++uses[body.name];
  }
  std::vector<std::set<std::string>> contacts(spaces.size());
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    for (const auto& element : spaces.multiplier(b).elements())
      contacts[b].insert(contact::nameOf(element));
    for (const std::string& name : contacts[b])
      ++uses[name];
  }
  for (std::size_t b = 0; b < spaces.size(); ++b)
    for (const std::string& name : contacts[b])
      row.contacts.push_back(
          {uses[name] > 1 ? bem::message(scene.bodies[b].name, ":", name) : name, {}, 0});
  return row;
}

Path followPath(const Ground& ground, const contact::ContactSystem& atZero,
                const std::vector<PathPoint>& earlier, PhaseTimer& timer,
                const std::function<void(const Path&)>& handOut) {
  Follower follower(ground, atZero, earlier, timer);
  for (const double time : ground.scene.history.times) {
    const bool reached = follower.goTo(time);
    handOut(follower.path());
    if (!reached)
      break;
  }
  return std::move(follower.path());
}

}  // namespace epafi::drivers
