#include "drivers/commands/RunCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/commands/Recorder.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Interrupt.hpp"
#include "drivers/process/ProgressLine.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <filesystem>
#include <iostream>
#include <optional>

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
    options.threads = positiveNumber("--threads", given.value("--threads"), mostThreads);
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
        "--force would delete the run that --restart goes on from; leave one of them out "
        "or give another --output");
  if (!scene.output.fields)
    throw bem::InputError(
        scene.file,
        ": Output->Fields = false writes no solution.hdf; --restart needs a new one in '",
        options.restart, "', or another --output");
  beginning.folder = options.restart;
  beginning.earlierRun = EarlierRun::Continue;
  return beginning;
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
