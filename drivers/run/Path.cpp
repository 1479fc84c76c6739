#include "drivers/run/Path.hpp"

#include "bem/base/Error.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/path/Prediction.hpp"
#include "drivers/run/LevelBalance.hpp"
#include "drivers/run/Solver.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace epafi::drivers {

namespace {

/// Where a path stands: what its next step depends on.
struct Standing {
  contact::PathMemory memory;
  contact::Prediction prediction;
  std::shared_ptr<const SolvedPart> part{};    ///< the last one
  std::shared_ptr<const SolvedPart> before{};  ///< and the one before
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

/// The error of a number in time from its differences, each between a solution and the one in
/// steps twice as long.
class Remainder {
 public:
  /// Of the last one: d/(r - 1), d the difference, r their ratio: 2 in first order, 4 in second.
  /// r is the smaller of the last two, for one may be large by chance; below 3 first order.  The
  /// first, of one, two and four steps, tells no order.
  /// Both solutions may miss what happens in between: d is at least the one before over r.
  /// Differences of both signs show no order: the number is within what it went through.
  double behind(double difference) {
    const double last = std::exchange(last_, difference);
    const double before = std::abs(last);
    const double now = std::abs(difference);
    const double falls = before > 0 ? before / std::max(now, 0.25 * before) : 0;
    const double least =
        std::min(falls, std::exchange(fell_, ++differences_ > 2 ? falls : 0));
    if (last * difference < 0)
      return before + now;
    const double ratio = least < 3 ? 2 : least;
    return std::max(now, before / ratio) / (ratio - 1);
  }

 private:
  double last_ = 0;  ///< difference
  double fell_ = 0;  ///< by which it fell
  int differences_ = 0;
};

class Follower {
 public:
  Follower(const BodySpaces& spaces, const PathStart& start, const Level& from,
           const Run& run, SolvedLevel& path)
      : scene_(spaces.scene()),
        spaces_(spaces),
        start_(start),
        from_(from),
        run_(run),
        known_(knownOf(from.path, scene_.history)),
        here_{contact::PathMemory(*start.system, scene_.history.tolerance > 0
                                                     ? contact::PathMemory::Shear::Mean
                                                     : contact::PathMemory::Shear::AtEnd),
              contact::Prediction(*start.system),
              std::make_shared<const SolvedPart>(spaces)},
        balance_(balanceOf(scene_)),
        path_(path),
        empty_(spaces.stepRow()) {}

  /// Up to a time; false where the path ends before it.
  bool goTo(double time) {
    row_ = empty_;
    row_.level = from_.number;
    if (scene_.history) {
      row_.step = static_cast<int>(path_.steps.size()) + 1;
      run_.timer.startStep(row_.step, static_cast<int>(scene_.history.times.size()));
      row_.t = time;
    }
    row_.parts = 0;
    while (here_.t < time && isKnown())
      solve(from_.path[points().size()].t);
    if (here_.t < time)
      follow(time);
    row_.converged = here_.t == time;
    run_.timer.run(Phase::Results, [&] { finish(); });
    return row_.converged;
  }

 private:
  contact::Report& report() { return path_.row.report; }
  std::vector<SolvedState>& points() const { return path_.level.path; }
  bool isKnown() const { return points().size() < known_; }

  /// How many points of an earlier run hold: under a tolerance those of sections that it
  /// finished, which are compared as a whole.
  static std::size_t knownOf(const std::vector<SolvedState>& earlier,
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
    const History& history = scene_.history;
    const Standing before = here_;
    const std::size_t known = points().size();
    const double whole = time - before.t;
    const double shortest = history.shortest(whole);
    double step = inSteps(time, whole, shortest);
    Remainder ofSum, ofWork, ofSlip, ofVolume;
    // kinks of single coefficients add up to less than they are, to much less only by chance
    constexpr double leastShare = 0.8;
    while (history.tolerance > 0 && here_.t == time &&
           0.5 * step >= (1 - 1e-9) * shortest) {
      const Standing there = std::exchange(here_, before);
      leavePoints(known);
      const double longest = 0.5 * step;
      step = inSteps(time, longest, shortest);
      if (here_.t < time)
        break;
      const contact::PathMemory::Difference now = here_.memory.apart(there.memory);
      const double sum = here_.memory.friction() - there.memory.friction();
      const contact::PathMemory::Difference error{
          std::max(ofSum.behind(sum), leastShare * ofWork.behind(now.work)),
          ofSlip.behind(now.slip), ofVolume.behind(now.volume)};
      points().back().workError = error.work;
      points().back().volumeError = error.volume;
      const double work = workOf(before, whole);
      // what friction does later with a wrong slip is not known yet
      const double later = 1e-2 * std::abs(here_.memory.outside());
      if (run_.processes.agreed(History::fewestSteps * longest <= whole &&
                                error.work <= history.tolerance * work &&
                                error.slip <= history.tolerance * std::max(work, later) &&
                                error.volume <=
                                    history.tolerance * volumeOf(before, whole)))
        break;
    }
  }

  /// All but the first ones; what they cost stays.
  void leavePoints(std::size_t first) {
    for (; points().size() > first; points().pop_back()) {
      newtonIterations_ += points().back().newtonIterations;
      coulombIterations_ += points().back().coulombIterations;
      --row_.parts;
    }
  }

  /// What friction's work, or the worn volume, since then may count as: its own, or its share of
  /// the path's.
  double counted(double now, double then, double whole, double least) const {
    return std::max({now - then, whole / scene_.endOfPath() * now, least});
  }
  double workOf(const Standing& before, double whole) const {
    return counted(here_.memory.friction(), before.memory.friction(), whole,
                   leastFriction * std::abs(here_.memory.outside()));
  }
  double volumeOf(const Standing& before, double whole) const {
    return counted(here_.memory.wornVolume(), before.memory.wornVolume(), whole,
                   leastVolume());
  }
  /// Displacements, and rounding of slips with them, are as large as the root of the work.
  double leastVolume() const {
    constexpr double rounding = 1e-9;
    return rounding * std::sqrt(std::abs(here_.memory.outside()));
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
      if (scene_.history)
        path_.ends = bem::message(
            "step ", row_.step, " of the path ends at t = ", here_.t,
            ", before t = ", time, ", although it was halved down to ", 2 * step);
      break;
    }
    return step;
  }

  SettledProblem attempt(contact::ContactSystem& system, double time) {
    // where solutions are not unique a path of one step shall find that of the load alone
    const bool isFirst = points().empty() && time == scene_.history.times.front();
    const auto first = [&] {
      return from_.steps.empty()
                 ? system.start()
                 : start_.system->with(from_.last().rigid, from_.last().state);
    };
    return settled(
        system,
        [&](const contact::State* before) {
          return drivers::solve(
              system, spaces_,
              [&] {
                return before != nullptr ? *before
                       : isFirst         ? first()
                                         : here_.prediction.start(system);
              },
              here_.prediction.last(), run_.processes, run_.timer);
        },
        run_.processes);
  }

  // One step to a time; what it ends with is kept also where it fails.
  bool solve(double next) {
    SettledProblem attempt;
    contact::Solution& solved = attempt.solution;
    const bool known = isKnown();
    std::shared_ptr<contact::ContactSystem> system;
    run_.timer.run(Phase::Stabilization, [&] {
      if (next == scene_.history.start()) {
        std::tie(conditions_, system) = std::tie(start_.conditions, start_.system);
        return;
      }
      conditions_ =
          std::make_shared<const SolvedStep::Conditions>(spaces_.conditionsAt(next));
      system = std::make_shared<contact::ContactSystem>(start_.system->under(
          *conditions_, scene_.drivesAt(next), here_.memory.forStep()));
    });
    if (known) {
      const SolvedState& point = from_.path[points().size()];
      solved.state = point.state;
      solved.report.newtonIterations = point.newtonIterations;
      solved.report.coulombIterations = point.coulombIterations;
      solved.report.status = contact::Status::Converged;
      solved.report.tolerance =  // at most
          std::max(scene_.solver.contact.tolerance, scene_.solver.coulomb.tolerance);
    } else {
      attempt =
          run_.timer.run(Phase::Newton, [&] { return this->attempt(*system, next); });
    }
    row_.newtonIterations += solved.report.newtonIterations;
    newtonIterations_ += solved.report.newtonIterations;
    coulombIterations_ += solved.report.coulombIterations;
    report() = contact::joined(solved.report, report());
    path_.level.reason = attempt.reason;
    const bool converged = solved.report.converged();
    if (solved.state.multiplier.empty())
      solved.state = here_.prediction.last();
    run_.timer.run(Phase::Newton, [&] {
      latestAt_ = converged && !known ? std::move(attempt.at)
                                      : system->configuration(solved.state);
      if (!converged && scene_.history)
        return;
      if (known)
        latestAt_ = contact::worn(*system, std::move(latestAt_));
      here_.memory.add(*system, latestAt_);
      if (!converged)
        return;
      here_.prediction.add(*system, latestAt_.state);
      here_.before = std::exchange(here_.part, std::make_shared<const SolvedPart>(
                                                   spaces_, conditions_, latestAt_));
    });
    system_ = std::move(system);
    if (converged) {
      here_.cycles += (next - here_.t) * cyclesOf(*conditions_);
      ++row_.parts;
      const SolvedState before = known ? from_.path[points().size()] : SolvedState();
      if (scene_.history)
        points().push_back({next, latestAt_.state, std::exchange(newtonIterations_, 0),
                            std::exchange(coulombIterations_, 0), before.workError,
                            before.volumeError});
      here_.t = next;
    }
    return converged;
  }

  // The step asked for, with everything that follows from its state.
  void finish() {
    const auto made = std::make_shared<SolvedStep>(
        spaces_, std::move(conditions_), std::move(system_), std::move(latestAt_),
        row_.converged ? here_.before : here_.part, here_.memory.wear());
    SolvedStep& step = *made;
    const contact::ContactSystem& system = *step.system;
    const double energy = scene_.energy();
    row_.energyStrain =
        wholeOf(scene_.symmetry, contact::sumOf(step.summaries())).energyStrain;
    const double strain = step.at.strainEnergy();
    const double stored = step.at.storedEnergy();
    row_.energyDissipated = energy * here_.memory.friction();
    double workError = 0;
    double volumeError = 0;
    for (const SolvedState& point : points()) {
      workError += point.workError;
      volumeError += point.volumeError;
    }
    row_.energyDissipatedError = energy * workError;
    if (volumeError > 0)
      row_.wornVolumeError =
          volumeError / std::max(here_.memory.wornVolume(), leastVolume());
    row_.energyTrapezoidal = energy * here_.memory.trapezoidal();
    row_.energyOutside = energy * here_.memory.outside();
    row_.energyStabilisation = energy * (stored - strain);
    row_.energyInterface =
        energy * system.numbers().surface.energy(step.at.state.multiplier);
    row_.energyStored = energy * stored + row_.energyInterface;
    row_.energyWorn = energy * here_.memory.worn();
    row_.cycles = here_.cycles;
    row_.energyError = energy * here_.memory.imbalance(row_.energyStored / energy);
    // springs do at bodies what their other ends take, less what they store
    row_.energySprings = energy * system.energyOfSprings(step.at.state);
    row_.energyOutside += row_.energySprings;
    row_.energyStored += row_.energySprings;
    step.addRigid(row_);
    step.row = row_;
    if (row_.converged) {
      checkBalance(balance_, run_, step, path_);
      row_.converged = path_.unbalanced.empty();
    }
    step.frictionWork = here_.memory.frictionWork();
    step.addContacts(row_);
    step.row = row_;
    path_.steps.push_back(made);
  }

  const Scene& scene_;
  const BodySpaces& spaces_;
  const PathStart& start_;
  const Level& from_;
  const Run& run_;
  const std::size_t known_;
  Standing here_;
  contact::Balance balance_;
  // since the last point, of what failed or was left, too
  int newtonIterations_ = 0;
  int coulombIterations_ = 0;
  SolvedLevel& path_;
  const StepRow empty_;
  StepRow row_;
  // of the last attempt
  std::shared_ptr<const SolvedStep::Conditions> conditions_;
  std::shared_ptr<const contact::ContactSystem> system_;
  contact::Configuration latestAt_;
};

}  // namespace

void followPath(const BodySpaces& spaces, const PathStart& start, const Level& from,
                const Run& run, const std::function<void()>& handOut, SolvedLevel& path) {
  Follower follower(spaces, start, from, run, path);
  for (const double time : spaces.scene().history.times) {
    const bool reached = follower.goTo(time);
    handOut();
    if (!reached)
      break;
  }
}

}  // namespace epafi::drivers
