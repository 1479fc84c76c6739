#include "drivers/run/Path.hpp"

#include "bem/base/Error.hpp"
#include "contact/solve/DefectCorrection.hpp"
#include "drivers/run/Solver.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace epafi::drivers {

namespace {

/// Where a path stands: what its next step depends on.
struct Standing {
  contact::PathMemory memory;
  contact::Prediction prediction;
  std::vector<contact::LoadResponses> responses{};
  double t = 0;
  double cycles = 0;
};

/// How many times a step happens, the most of all contacts.
double cyclesOf(const std::vector<contact::Conditions>& conditions) {
  double most = 1;
  for (const contact::Conditions& ofBody : conditions)
    for (const auto& [boundary, contact] : ofBody.contact)
      most = std::max(most, contact.cycles);
  return most;
}

class Follower {
 public:
  Follower(const Ground& ground, const contact::ContactSystem& atZero,
           const contact::State& first, const std::vector<PathPoint>& earlier,
           PhaseTimer& timer)
      : ground_(ground),
        atZero_(atZero),
        first_(first),
        earlier_(earlier),
        known_(knownOf(earlier, ground.scene.history)),
        timer_(timer),
        here_{contact::PathMemory(atZero, ground.scene.history.tolerance > 0
                                              ? contact::PathMemory::Shear::Mean
                                              : contact::PathMemory::Shear::AtEnd),
              contact::Prediction(atZero)},
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
    timer_.startStep(row_.step, static_cast<int>(ground_.scene.history.times.size()));
    row_.t = time;
    row_.parts = 0;
    while (here_.t < time && isKnown())
      solve(earlier_[path_.points.size()].t);
    if (here_.t < time)
      follow(time);
    row_.converged = here_.t == time;
    timer_.run(Phase::Results, [&] { finish(); });
    return row_.converged;
  }

  Path& path() { return path_; }

 private:
  contact::Report& report() { return path_.report; }
  bool isKnown() const { return path_.points.size() < known_; }

  /// How many points of an earlier run hold: under a tolerance those of sections that it
  /// finished, which are compared as a whole.
  static std::size_t knownOf(const std::vector<PathPoint>& earlier,
                             const History& history) {
    std::size_t known = earlier.size();
    while (history.tolerance > 0 && known > 0 &&
           std::find(history.times.begin(), history.times.end(), earlier[known - 1].t) ==
               history.times.end())
      --known;
    return known;
  }

  /// Up to a time at once; with a tolerance again and again in steps half as long, until friction
  /// does the same in both.
  void follow(double time) {
    const History& history = ground_.scene.history;
    const Standing before = here_;
    const std::size_t points = path_.points.size();
    const double whole = time - before.t;
    const double shortest = history.shortest(whole);
    double step = inSteps(time, whole, shortest);
    contact::PathMemory::Difference last;
    while (history.tolerance > 0 && here_.t == time &&
           0.5 * step >= (1 - 1e-9) * shortest) {
      const Standing there = std::exchange(here_, before);
      leavePoints(points);
      const double longest = 0.5 * step;
      step = inSteps(time, longest, shortest);
      if (here_.t < time)
        break;
      // of what is of first order half as much is left as before; where nothing is, both may
      // have missed what happens in between
      const contact::PathMemory::Difference now = here_.memory.apart(there.memory);
      const contact::PathMemory::Difference error{
          std::max(now.work, 0.5 * last.work), std::max(now.slip, 0.5 * last.slip),
          std::max(now.volume, 0.5 * last.volume)};
      last = now;
      path_.points.back().workError = error.work;
      const double work = workOf(before, whole);
      // what friction does later with a wrong slip is not known yet
      const double later = 1e-2 * std::abs(here_.memory.outside());
      if (ground_.processes.agreed(
              History::fewestSteps * longest <= whole &&
              error.work <= history.tolerance * work &&
              error.slip <= history.tolerance * std::max(work, later) &&
              error.volume <= history.tolerance * volumeOf(before, whole)))
        break;
    }
  }

  /// All but the first ones; what they cost stays.
  void leavePoints(std::size_t first) {
    for (; path_.points.size() > first; path_.points.pop_back()) {
      newtonIterations_ += path_.points.back().newtonIterations;
      coulombIterations_ += path_.points.back().coulombIterations;
      --row_.parts;
    }
  }

  /// What friction's work since then may count as: its own, or its share of the path's.
  double workOf(const Standing& before, double whole) const {
    const double sofar = here_.memory.friction();
    const double share = whole / ground_.scene.endOfPath();
    return std::max({sofar - before.memory.friction(), share * sofar,
                     leastFriction * std::abs(here_.memory.outside())});
  }

  /// The worn volume likewise.
  double volumeOf(const Standing& before, double whole) const {
    const double sofar = here_.memory.wornVolume();
    return std::max(sofar - before.memory.wornVolume(),
                    whole / ground_.scene.endOfPath() * sofar);
  }

  /// Up to a time in steps, halved where one fails; the path may end before.  Returns the last
  /// length: where steps are compared with shorter ones, those are shorter than all of these.
  double inSteps(double time, double step, double shortest) {
    while (here_.t < time) {
      // rounding shall not leave a tiny last part
      const double next = here_.t + step > time - 1e-9 * step ? time : here_.t + step;
      if (solve(next))
        continue;
      step *= 0.5;
      if (step >= shortest)
        continue;
      path_.reason = bem::message(
          "step ", row_.step, " of the path ends at t = ", here_.t, ", before t = ", time,
          ", although it was halved down to ", 2 * step, ": ", path_.reason);
      break;
    }
    return step;
  }

  /// A step, again and again where it wears by its slip, until that does not change any more.
  SolvedProblem settled(contact::ContactSystem& system, double time) {
    constexpr double same = 1e-12;
    constexpr double almost = 1e-8;  // where rounding changes it on and on
    constexpr int most = 100;
    const auto solveFrom = [&](const contact::State* start) {
      return solveStep(ground_.scene, system, ground_.spaces, here_.prediction, start,
                       ground_.processes, timer_);
    };
    // where solutions are not unique a path of one step shall find that of the load alone
    const bool isFirst =
        path_.points.empty() && time == ground_.scene.history.times.front();
    SolvedProblem solved = solveFrom(isFirst ? &first_ : nullptr);
    double last = 1;
    for (int k = 0; system.wearsBySlip() && solved.solution.report.converged(); ++k) {
      const double change = system.wearBy(system.configuration(solved.solution.state));
      if (ground_.processes.agreed(change <= same ||
                                   (change < almost && change > last / 2)))
        break;
      if (k == most) {
        solved.solution.report.status = contact::Status::NotConverged;
        solved.reason = bem::message(
            "what wears and the slip that it wears by do not settle, the last change is ",
            change, "; shorten Wear->Cycle Jump");
        break;
      }
      last = change;
      SolvedProblem next = solveFrom(&solved.solution.state);
      next.solution.report =
          contact::joined(std::move(next.solution.report), solved.solution.report);
      solved = std::move(next);
    }
    return solved;
  }

  // One step to a time; what it ends with is kept also where it fails.
  bool solve(double next) {
    SolvedProblem attempt;
    contact::Solution& solved = attempt.solution;
    const bool known = isKnown();
    auto now = std::make_unique<PathStep>();
    std::unique_ptr<contact::ContactSystem> system;
    timer_.run(Phase::Stabilization, [&] {
      now->conditions = ground_.spaces.conditionsAt(next);
      system = std::make_unique<contact::ContactSystem>(atZero_.under(
          {now->conditions, ground_.scene.drivesAt(next), here_.memory.slip(),
           here_.memory.defect(), here_.memory.largestLoad(), here_.responses,
           here_.memory.wear()}));
    });
    if (known) {
      const PathPoint& point = earlier_[path_.points.size()];
      solved.state = point.state;
      solved.report.newtonIterations = point.newtonIterations;
      solved.report.coulombIterations = point.coulombIterations;
      solved.report.status = contact::Status::Converged;
    } else {
      attempt = timer_.run(Phase::Newton, [&] { return settled(*system, next); });
    }
    row_.newtonIterations += solved.report.newtonIterations;
    newtonIterations_ += solved.report.newtonIterations;
    coulombIterations_ += solved.report.coulombIterations;
    report() = contact::joined(solved.report, report());
    path_.reason = attempt.reason;
    const bool converged = solved.report.converged();
    if (solved.state.multiplier.empty())
      solved.state = here_.prediction.last();
    timer_.run(Phase::Newton, [&] {
      latestAt_ = converged && !known
                      ? contact::corrected(*system, solved.state, ground_.processes)
                      : system->configuration(solved.state);
      if (!converged)
        return;
      if (system->wearBy(latestAt_) > 0)
        latestAt_ = system->configuration(latestAt_.state);
      here_.memory.add(*system, latestAt_);
      here_.prediction.add(*system, latestAt_.state);
      here_.responses = system->responses();
    });
    now->system = std::move(system);
    if (converged) {
      here_.cycles += (next - here_.t) * cyclesOf(now->conditions);
      ++row_.parts;
      path_.points.push_back({next, latestAt_.state, std::exchange(newtonIterations_, 0),
                              std::exchange(coulombIterations_, 0),
                              known ? earlier_[path_.points.size()].workError : 0});
      here_.t = next;
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
                                                       std::move(latestAt_), &before,
                                                       here_.memory.wear());
    const contact::Configuration& at = step.solved->at();
    const Scene& scene = ground_.scene;
    const double energy = scene.energy();
    if (scene.tellsBodies())
      row_.bodies = contact::summarizeAll(step.solved->bodies());
    double ofInside = 0;
    for (const contact::Solved& solved : step.solved->bodies())
      ofInside += contact::energiesOfInside(solved).strain;
    const double strain =
        row_.bodies.empty()
            ? system.strainEnergy(at)
            : wholeOf(scene.symmetry, contact::sumOf(row_.bodies)).energyStrain / energy -
                  ofInside;
    const double stored = system.storedEnergy(at);
    row_.energyStrain = energy * (strain + ofInside);
    row_.energyDissipated = energy * here_.memory.friction();
    double error = 0;
    for (const PathPoint& point : path_.points)
      error += point.workError;
    row_.energyDissipatedError = energy * error;
    row_.energyTrapezoidal = energy * here_.memory.trapezoidal();
    row_.energyOutside = energy * here_.memory.outside();
    row_.energyStabilisation = energy * (stored - strain);
    row_.energyInterface = step.solved->interfaceEnergy();
    row_.energyStored = energy * stored + row_.energyInterface;
    row_.energyWorn = energy * here_.memory.worn();
    row_.cycles = here_.cycles;
    row_.energyError = energy * here_.memory.imbalance(row_.energyStored / energy);
    // springs do at bodies what their other ends take, less what they store
    row_.energySprings = energy * system.energyOfSprings(at.state);
    row_.energyOutside += row_.energySprings;
    row_.energyStored += row_.energySprings;
    row_.bodies = wholeBodies(scene, std::move(row_.bodies));
    row_.rigid = step.solved->rigidRows();
    auto contact = row_.contacts.begin();
    for (std::size_t b = 0; b < system.size(); ++b) {
      step.frictionWork.push_back(
          system.numbering().tangentialsOf(b, here_.memory.frictionWork()));
      auto work = contact::frictionWorkOfContacts(system.body(b).multiplier(),
                                                  step.frictionWork[b]);
      for (const auto& [name, summary] :
           contact::summarizeContacts(step.solved->bodies()[b])) {
        const bem::Outline& outline = *scene.bodies[b].outline;
        contact->summary = wholeOf(scene.symmetry, outline, summary);
        const double share =
            scene.symmetry.cuts(outline) ? 1 : 1 / scene.symmetry.copies();
        contact->dissipated = share * energy * work[name];
        ++contact;
      }
    }
    step.row = row_;
    path_.steps.push_back(std::move(latest_));
  }

  const Ground& ground_;
  const contact::ContactSystem& atZero_;
  const contact::State& first_;
  const std::vector<PathPoint>& earlier_;
  const std::size_t known_;
  PhaseTimer& timer_;
  Standing here_;
  // since the last point, of what failed or was left, too
  int newtonIterations_ = 0;
  int coulombIterations_ = 0;
  Path path_;
  const StepRow empty_;
  StepRow row_;
  std::unique_ptr<PathStep> latest_;
  contact::Configuration latestAt_;
};

}  // namespace

StepRow emptyRow(const Scene& scene, const BodySpaces& spaces) {
  StepRow row;
  std::map<std::string, int> uses;  // of a name
  for (const RigidBody& body : scene.rigid) {
    row.rigid.push_back({body.name, body.pole, {}, {}, {}, {}, {}});
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
                const contact::State& first, const std::vector<PathPoint>& earlier,
                PhaseTimer& timer, const std::function<void(const Path&)>& handOut) {
  Follower follower(ground, atZero, first, earlier, timer);
  for (const double time : ground.scene.history.times) {
    const bool reached = follower.goTo(time);
    handOut(follower.path());
    if (!reached)
      break;
  }
  return std::move(follower.path());
}

}  // namespace epafi::drivers
