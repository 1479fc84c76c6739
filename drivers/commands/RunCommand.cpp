#include "drivers/commands/RunCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/commands/CommandLine.hpp"
#include "drivers/output/FieldFiles.hpp"
#include "drivers/output/LevelTable.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/SolutionFile.hpp"
#include "drivers/process/BlasCore.hpp"
#include "drivers/process/Interrupt.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <unistd.h>
#include <utility>

namespace epafi::drivers {

namespace {

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

/// The files of a level take the place of those of the level before, the one that a
/// restart begins with last.  That one is written by all processes, the others by the
/// first, which alone has a folder.
void writeLevel(const Scene& scene, const SolvedLevel& level, const RunRecord& run,
                const std::string& path, std::optional<OutputFolder>& folder) {
  const auto writer = [&](const std::string& file) { writeSolution(file, level, run); };
  if (!folder) {
    if (scene.output.fields)
      writer(temporaryFile(path, "solution.hdf"));
    return;
  }
  folder->stage("history.csv", run.history);
  if (!scene.conditions.contact.empty())
    folder->stage("contact.csv", contactCsv(level.solved, scene.output.contactSamples));
  if (scene.output.fields)
    folder->stage("boundary.csv", boundaryCsv(level.solved, level.result.density));
  if (!scene.output.interiorPoints.empty())
    folder->stage("interior.csv",
                  interiorCsv(level.solved, level.result.density, scene.material,
                              scene.output.interiorPoints));
  if (scene.output.fields)
    folder->stage("solution.hdf", writer);
  folder->commit();
  if (scene.output.interiorPoints.empty())
    folder->drop("interior.csv");
}

std::string filesWritten(const OutputFolder& folder) {
  std::string text = "files   " + folder.path() + ":";
  for (const std::string& name : folder.written())
    text += " " + name;
  return text + "\n";
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

/// What the first process says: it may run on another kind of machine.
std::string agreed(const std::string& text, const bem::DenseAlgebra& algebra) {
  const bem::Vector same = algebra.broadcast({text.begin(), text.end()});
  return {same.begin(), same.end()};
}

struct Ending {
  Outcome outcome;
  int levels = 0;  ///< solved by this run
};

/// Writes the levels' files as they are solved, and timings.txt if that fails.
Ending solveAndWrite(const Scene& scene, const Beginning& beginning, const Ranks& ranks,
                     PhaseTimer& timer, std::optional<OutputFolder>& folder,
                     std::ostream& table, std::string& stages) {
  const auto& earlier = beginning.earlier;
  const RunRecord before = earlier ? earlier->run : RunRecord{"", historyHead(), 0, 0};
  RunRecord run = before;
  run.used = agreed(usedXml(scene), ranks.algebra());
  int levels = 0;
  const auto handOut = [&](const SolvedLevel& level) {
    ++levels;
    LevelRow row = level.row;
    row.secondsTotal += before.secondsTotal;
    row.secondsWall += before.secondsWall;
    run.history += historyLine(row);
    run.secondsTotal = row.secondsTotal;
    run.secondsWall = row.secondsWall;
    writeLevel(scene, level, run, beginning.folder, folder);
    if (!folder)
      return;
    stages +=
        bem::message("level ", row.level, ": ", contact::told(row.report.stages), "\n");
    timer.clearLine();
    table << tableLine(row) << gamma0Note(row, scene.stabilization.firstGamma0())
          << std::flush;
  };
  try {
    Outcome outcome =
        solveLevels(scene, ranks, timer, handOut,
                    earlier ? std::optional(earlier->result) : std::nullopt);
    return {std::move(outcome), levels};
  } catch (...) {
    try {
      if (folder)
        folder->write("timings.txt", timer.report() + stages);
    } catch (const bem::InputError&) {  // what went wrong first is what is told
    }
    throw;
  }
}

}  // namespace

int runCommand(const std::vector<std::string>& arguments, std::ostream& out,
               const Ranks& ranks) {
  const RunOptions options = parseRunOptions(arguments);
  const Scene scene = readScene(options.scene, options.overrides);
  if (options.threads > 0 || ranks.underMpirun())
    setThreads(std::max(options.threads, 1));
  const Beginning beginning = begin(options, scene);
  std::optional<OutputFolder> folder;  // the first rank's
  if (ranks.isFirst())
    folder.emplace(beginning.folder, beginning.earlierRun);
  catchSignals();
  if (folder && beginning.earlier)  // without rows of levels that did not make it
    folder->write("history.csv", beginning.earlier->run.history);
  if (folder)
    folder->write("used.xml", usedXml(scene));

  std::ostream silence(nullptr);
  std::ostream& table = options.quiet ? silence : out;
  table << scene.title << " (" << scene.file << "), BLAS core " << versions().blasCore
        << ", " << processesAndThreads(ranks.algebra().processes()) << "\n";
  if (beginning.earlier)
    table << "goes on behind level " << beginning.earlier->result.level << " in "
          << options.restart << "\n";
  table << tableHead() << std::flush;

  const bool shown = ranks.isFirst() && !options.quiet && isatty(STDERR_FILENO) != 0;
  std::string stages = "\nSolver stages, steps, how they ended\n";
  PhaseTimer timer(shown ? Progress::Shown : Progress::Silent);
  const auto [outcome, levels] =
      solveAndWrite(scene, beginning, ranks, timer, folder, table, stages);

  const bool converged = outcome.status == contact::Status::Converged;
  const int code = converged ? 0 : 3;
  if (!folder)
    return code;
  folder->write("timings.txt", timer.report() + stages);
  (converged ? table : std::cerr)
      << (converged ? "ended   " : "epafi: ") << outcome.reason << "\n";
  table << timeSummary(timer) << filesWritten(*folder);
  const bool elsewhere =
      beginning.earlier && beginning.earlierRun != EarlierRun::Continue;
  if (levels == 0 && elsewhere)
    table << "        nothing was left to solve: the fields of level "
          << beginning.earlier->result.level << " are in " << options.restart << "\n";
  return code;
}

int versionCommand(const std::vector<std::string>& arguments, std::ostream& out) {
  if (!arguments.empty())
    throw bem::InputError(bem::message("version: argument '", arguments.front(),
                                       "' is not understood; it takes none"));
  const Versions v = versions();
  out << "Epafi " << v.epafi << "\nTrilinos " << v.trilinos << "\nMPI " << v.mpi
      << "\nBLAS core " << v.blasCore << "\n";
  return 0;
}

}  // namespace epafi::drivers
