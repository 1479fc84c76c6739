#include "drivers/commands/RunCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/BodiesTable.hpp"
#include "drivers/output/BodyInsides.hpp"
#include "drivers/output/BoundaryTable.hpp"
#include "drivers/output/BoundaryVtu.hpp"
#include "drivers/output/ContactTable.hpp"
#include "drivers/output/Csv.hpp"
#include "drivers/output/HistoryTable.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/PathContactTable.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/SolutionFile.hpp"
#include "drivers/output/StepsTable.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Interrupt.hpp"
#include "drivers/process/ProgressLine.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>
#include <utility>

namespace epafi::drivers {

namespace {

/// The arguments of `epafi run`.
struct RunOptions {
  std::string scene;
  std::string output;
  std::string restart;  ///< folder of the run to go on from; empty: begin anew
  std::vector<std::string> overrides;
  int threads = 0;  ///< 0: the default
  bool force = false;
  bool quiet = false;
};

RunOptions optionsOf(const Given& given) {
  RunOptions options;
  options.scene = given.argument;
  options.output = given.value("--output");
  options.restart = given.value("--restart");
  options.overrides = given.values("--set");
  if (given.has("--threads"))
    options.threads = positiveNumber("--threads", given.value("--threads"));
  options.force = given.has("--force");
  options.quiet = given.has("--quiet");
  return options;
}

/// What a run goes on from, and where it writes.
struct Beginning {
  std::optional<Checkpoint> earlier;
  std::string folder;
  EarlierRun earlierRun = EarlierRun::Refuse;
};

/// Reads before anything is touched.
Beginning begin(const RunOptions& options, const Scene& scene) {
  Beginning beginning;
  beginning.earlierRun = options.force ? EarlierRun::Delete : EarlierRun::Refuse;
  beginning.folder = options.output;
  if (options.restart.empty()) {
    if (beginning.folder.empty())
      beginning.folder = defaultOutputFolder(options.scene);
    return beginning;
  }
  beginning.earlier = readRestart(options.restart, scene);
  std::error_code ignored;
  if (!options.output.empty() &&
      !std::filesystem::equivalent(options.restart, options.output, ignored))
    return beginning;
  if (options.force)
    throw bem::InputError(
        "--force would delete the run that --restart goes on from; "
        "leave one of them out or give another --output");
  if (!scene.output.fields)
    throw bem::InputError(bem::message(
        scene.file,
        ": Output->Fields = false writes no solution.hdf; --restart needs a new one in '",
        options.restart, "', or another --output"));
  beginning.folder = options.restart;
  beginning.earlierRun = EarlierRun::Continue;
  return beginning;
}

/// What the steps of a path leave in files.
struct PathRecord {
  std::string steps;                    ///< steps.csv of all levels so far
  std::vector<std::string> contacts;    ///< contact.csv of the steps of this level
  std::vector<std::string> boundaries;  ///< likewise boundary.vtu
  std::vector<double> times;            ///< likewise
};

/// What a solved level leaves in files, good after its operators are gone.
struct LevelFiles {
  std::string contact;
  BoundaryLines grid;
  double secondsTotal = 0;
  double secondsWall = 0;
};

/// How much work may wait for its files [CPU seconds]: so much of a run is lost at most if it
/// is killed, and files of small levels cost as much as solving them.
constexpr double longestWait = 0.5;

/// On the level that ends a run only: many points cost more than the levels.
void writeInterior(const Scene& scene, const Level& level, OutputFolder& folder) {
  const BodyInsides insides(scene, level);
  const std::vector<bem::Vec2>& points = scene.output.interiorPoints;
  folder.write("interior.csv", insides.csv(points, insides.at(points)));
}

std::string filesWritten(const OutputFolder& folder) {
  std::string text = "files   " + folder.path() + ":";
  for (const std::string& name : folder.written())
    text += " " + name;
  return text + "\n";
}

/// "behind level 2", "in level 2, behind 7 solved steps"
std::string placeOf(const Level& level) {
  const std::string number = std::to_string(level.number);
  return level.complete ? "behind level " + number
                        : "in level " + number + ", behind " +
                              std::to_string(level.path.size()) + " solved steps";
}

/// "1 thread", "2 processes with 1 thread each"
std::string processesAndThreads(int processes) {
  const auto count = [](int n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  const std::string text = count(threads(), "thread", "threads");
  return processes == 1
             ? text
             : count(processes, "process", "processes") + " with " + text + " each";
}

/// Takes the levels of a run as they are solved: as lines of the table, and into the files of
/// the folder, which the first process alone has; `written` is told the number of the level
/// whose files these are.
class Recorder {
 public:
  Recorder(const Scene& scene, const std::optional<Checkpoint>& earlier,
           std::optional<OutputFolder>& folder, const ProgressLine& progress,
           std::ostream& table, std::function<void(int)> written)
      : scene_(scene),
        earlier_(earlier),
        folder_(folder),
        progress_(progress),
        table_(table),
        written_(std::move(written)),
        used_(usedXml(scene)),
        history_(earlier ? earlier->history : historyHead()),
        bodies_(earlier && !earlier->resultants.empty() ? earlier->resultants
                                                        : bodiesHead()),
        path_{earlier ? earlier->steps : "", {}, {}, {}},
        contact_(scene) {
    if (!folder_)
      return;
    if (earlier_)  // without rows of levels that did not make it
      folder_->write("history.csv", history_);
    folder_->write("used.xml", used_);
    folder_->drop("interior.csv");  // of an earlier level
    if (earlier_)
      last_ = earlier_->level;
  }

  int levels() const { return levels_; }
  /// Of the last level.
  const std::vector<std::string>& warnings() const { return warnings_; }

  void take(const SolvedLevel& level) {
    ++levels_;
    if (!folder_)
      return;
    note(level);
    warnings_ = warningsOf(scene_, level);
    if (level.row.operators == denseInstead)
      told_.push_back(bem::message("level ", level.row.level, ": ", level.row.note));
    warnings_.insert(warnings_.begin(), told_.begin(), told_.end());
    if (level.path != nullptr || cpuSeconds() - writtenAt_ > longestWait)
      write();
  }

  /// The files of the level taken last, if they wait: they take the place of those of the level
  /// before, the one that a restart begins with last.
  void write() {
    if (!waiting_)
      return;
    folder_->stage("history.csv", history_);
    for (std::size_t k = 0; k < path_.contacts.size(); ++k)
      folder_->stage(stepFile(k + 1, "contact.csv"), path_.contacts[k]);
    for (std::size_t k = 0; k < path_.boundaries.size(); ++k)
      folder_->stage(stepFile(k + 1, "boundary.vtu"), path_.boundaries[k]);
    if (!path_.boundaries.empty())
      folder_->stage("steps.pvd", stepsPvd(path_.times));
    if (scene_.hasContact())
      folder_->stage("contact.csv", waiting_->contact);
    if (scene_.output.fields)
      folder_->stage("boundary.csv", boundaryCsv(scene_, waiting_->grid));
    if (scene_.hasSeveral())
      folder_->stage("bodies.csv", bodies_);
    if (scene_.output.fields)
      folder_->stage("solution.hdf", solution(*last_, waiting_->secondsTotal,
                                              waiting_->secondsWall, waiting_->grid));
    folder_->commit();
    path_ = {path_.steps, {}, {}, {}};
    waiting_.reset();
    writtenAt_ = cpuSeconds();
    written_(last_->number);
  }

  /// What is written once, from the last level that there is.
  void finish(PhaseTimer& timer) {
    if (folder_)
      timer.run(Phase::Results, [&] {
        write();
        if (last_ && !scene_.output.interiorPoints.empty())
          writeInterior(scene_, *last_, *folder_);
      });
    writeTimings(timer);
  }

  /// A step on the way to a level: what a run that is killed now goes on from.
  void takeStep(SolvedLevel level) {
    if (!folder_)
      return;
    if (earlier_) {
      level.row.secondsTotal += earlier_->secondsTotal;
      level.row.secondsWall += earlier_->secondsWall;
    }
    const StepRow& row = level.path->steps.back()->row;
    const std::string head = stepsHead(row);
    path_.steps = path_.steps.empty() ? head : underHead(path_.steps, head);
    path_.steps += stepsLine(row);
    path_.contacts.push_back(contact_.next(level));
    path_.times.push_back(row.t);
    if (scene_.hasSeveral())
      bodies_ += bodiesLines(scene_, row.level, row.step, row.bodies, row.rigid);
    folder_->stage("steps.csv", path_.steps);
    if (scene_.output.fields) {
      const BoundaryLines grid = boundaryLines(scene_, level);
      path_.boundaries.push_back(boundaryVtu(grid));
      folder_->stage("solution.hdf", solution(level.level, level.row.secondsTotal,
                                              level.row.secondsWall, grid));
    }
    folder_->commit();
    progress_.clear();
    table_ << tableLine(row) << std::flush;
  }

  void writeTimings(PhaseTimer& timer) {
    if (folder_)
      folder_->write("timings.txt", timer.report() + stages_);
  }

 private:
  std::string solution(const Level& level, double secondsTotal, double secondsWall,
                       const BoundaryLines& grid) const {
    return solutionFile(scene_,
                        {level, used_, history_, path_.steps,
                         scene_.hasSeveral() ? bodies_ : "", secondsTotal, secondsWall},
                        grid);
  }

  void note(SolvedLevel level) {
    if (earlier_) {
      level.row.secondsTotal += earlier_->secondsTotal;
      level.row.secondsWall += earlier_->secondsWall;
    }
    history_ += historyLine(level.row);
    stages_ += bem::message("level ", level.row.level, ": ",
                            contact::told(level.row.report.stages), "\n");
    if (level.path == nullptr)
      bodies_ +=
          bodiesLines(scene_, level.row.level, 0, level.row.bodies, level.row.rigid);
    waiting_ = LevelFiles();
    if (!path_.contacts.empty())
      waiting_->contact = path_.contacts.back();
    else if (scene_.hasContact())
      waiting_->contact = contactCsv(scene_, level.bodies);
    if (scene_.output.fields)
      waiting_->grid = boundaryLines(scene_, level);
    waiting_->secondsTotal = level.row.secondsTotal;
    waiting_->secondsWall = level.row.secondsWall;
    last_ = level.level;
    contact_ = PathContact(scene_);
    progress_.clear();
    table_ << tableLine(level.row)
           << gamma0Note(level.row, scene_.stabilization.firstGamma0())
           << operatorsNote(level.row) << std::flush;
  }

  const Scene& scene_;
  const std::optional<Checkpoint>& earlier_;
  std::optional<OutputFolder>& folder_;
  const ProgressLine& progress_;
  std::ostream& table_;
  std::function<void(int)> written_;
  std::string used_;
  std::string history_;
  std::string bodies_;  ///< bodies.csv of all levels so far
  PathRecord path_;
  PathContact contact_;
  std::string stages_ = "\nSolver stages, steps, how they ended\n";
  std::optional<Level> last_;
  std::optional<LevelFiles> waiting_;  ///< of the last level, until they are written
  double writtenAt_ = cpuSeconds();
  std::vector<std::string> warnings_;
  std::vector<std::string> told_;  ///< likewise, of all levels
  int levels_ = 0;
};

/// What an interrupted run says; `level`: the last one that is written, or -1.
std::string advice(const RunOptions& options, const Scene& scene,
                   const std::string& folder, int level) {
  if (level < 0)
    return "interrupted before a level was written; nothing is kept";
  if (!scene.output.fields)
    return bem::message("interrupted behind level ", level, "; its files are in ", folder,
                        ", but Output->Fields = false leaves nothing to go on from");
  std::string command = "epafi run " + options.scene;
  for (const std::string& assignment : options.overrides)
    command += " --set '" + assignment + "'";
  return bem::message("interrupted behind level ", level, "; to go on from it: ", command,
                      " --restart ", folder);
}

/// For people, so not under --quiet.
void warn(const std::vector<std::string>& warnings, const RunOptions& options) {
  if (!options.quiet)
    for (const std::string& warning : warnings)
      std::cerr << "epafi: warning: " << warning << "\n";
}

/// The last level and timings.txt are written also if a later one fails or is interrupted.
Outcome solveAndRecord(const Scene& scene, const std::optional<Checkpoint>& earlier,
                       const Ranks& ranks, PhaseTimer& timer, Recorder& recorder) {
  try {
    return solveLevels(
        scene, ranks, timer, [&](const SolvedLevel& level) { recorder.take(level); },
        earlier ? std::optional(earlier->level) : std::nullopt,
        [&](const SolvedLevel& level) { recorder.takeStep(level); });
  } catch (...) {
    try {
      recorder.write();
      recorder.writeTimings(timer);
    } catch (const bem::InputError&) {  // what went wrong first is what is told
    }
    throwIfInterrupted();  // with the advice of what is written now
    throw;
  }
}

}  // namespace

int runCommand(const Given& given, std::ostream& out, const Ranks& ranks) {
  const RunOptions options = optionsOf(given);
  const Scene scene = readScene(options.scene, options.overrides);
  chooseThreads(options.threads, ranks);
  const Beginning beginning = begin(options, scene);
  std::optional<OutputFolder> folder;  // the first rank's
  if (ranks.isFirst())
    folder.emplace(beginning.folder, beginning.earlierRun);
  ranks.listenToSignals();
  adviseOnInterrupt(advice(options, scene, options.restart,
                           beginning.earlier ? beginning.earlier->level.number : -1));
  std::ostream silence(nullptr);
  std::ostream& table = options.quiet ? silence : out;
  const ProgressLine progress(progressIf(ranks.isFirst() && !options.quiet));
  Recorder recorder(scene, beginning.earlier, folder, progress, table, [&](int level) {
    adviseOnInterrupt(advice(options, scene, beginning.folder, level));
  });
  table << scene.title << " (" << scene.file << "), BLAS core " << versions().blasCore
        << ", " << processesAndThreads(ranks.algebra().processes()) << "\n";
  if (beginning.earlier)
    table << "goes on " << placeOf(beginning.earlier->level) << " in " << options.restart
          << "\n";
  if (ranks.isFirst())
    warn(warningsOf(scene), options);
  table << tableHead() << std::flush;

  PhaseTimer timer([&](const std::string& phase) {
    throwIfInterrupted();
    progress.show(phase);
  });
  const auto outcome = solveAndRecord(scene, beginning.earlier, ranks, timer, recorder);
  progress.clear();

  const bool converged = outcome.status == contact::Status::Converged;
  const int code = converged ? Solved : NotConverged;
  if (!folder)
    return code;
  recorder.finish(timer);
  warn(recorder.warnings(), options);
  (converged ? table : std::cerr)
      << (converged ? "ended   " : "epafi: ") << outcome.reason << "\n";
  table << timeSummary(timer) << filesWritten(*folder);
  const bool elsewhere =
      beginning.earlier && beginning.earlierRun != EarlierRun::Continue;
  if (recorder.levels() == 0 && elsewhere)
    table << "        nothing was left to solve: the fields of level "
          << beginning.earlier->level.number << " are in " << options.restart << "\n";
  return code;
}

int versionCommand(const Given&, std::ostream& out) {
  const Versions v = versions();
  out << "Epafi " << v.epafi << "\nTrilinos " << v.trilinos << "\nMPI " << v.mpi
      << "\nBLAS core " << v.blasCore << "\n";
  return 0;
}

}  // namespace epafi::drivers
