#include "bem/base/Error.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/commands/Recorder.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/process/ExitCode.hpp"
#include "drivers/process/Interrupt.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <filesystem>
#include <iostream>
#include <map>
#include <optional>

namespace epafi::drivers {

namespace {

/// The checkpoint that a run continues, and its folder.
struct Beginning {
  std::optional<Checkpoint> earlier;
  std::string folder;
  EarlierRun earlierRun = EarlierRun::Refuse;
};

/// Reads all input before any file is changed.
Beginning begin(const Given& given, const Scene& scene) {
  const bool force = given.has("--force");
  const std::string output = given.value("--output");
  const std::string restart = given.value("--restart");
  Beginning beginning{{}, output, force ? EarlierRun::Delete : EarlierRun::Refuse};
  if (restart.empty()) {
    if (output.empty())
      beginning.folder = defaultOutputFolder(given.argument);
    return beginning;
  }
  beginning.earlier = readRestart(restart, scene);
  std::error_code ignored;
  if (!output.empty() && !std::filesystem::equivalent(restart, output, ignored))
    return beginning;
  if (force)
    throw bem::InputError(
        "--force would delete the run that --restart goes on from; leave one of them out "
        "or give another --output");
  if (!scene.output.fields)
    throw bem::InputError(
        scene.file,
        ": Output->Fields = false writes no solution.hdf; --restart needs a new one in '",
        restart, "', or another --output");
  return {std::move(beginning.earlier), restart, EarlierRun::Continue};
}

/// The files of steps by their last step: "steps/1..49/contact.csv".
std::string filesWritten(const OutputFolder& folder) {
  std::vector<std::string> names;
  std::map<std::string, std::string> ofSteps;  // by the name in the last step's folder
  for (const std::string& name : folder.written()) {
    const std::filesystem::path file(name);
    if (file.has_parent_path())
      ofSteps[file.filename()] = file.parent_path().filename();
    else
      names.push_back(name);
  }
  std::string text = "files   " + folder.path() + ":";
  for (const std::string& name : names)
    text += " " + name;
  for (const auto& [name, last] : ofSteps)
    text += " steps/1.." + last + "/" + name;
  return text + "\n";
}

/// "after level 2", "in level 2, after 7 solved steps"
std::string placeOf(const Level& level) {
  const std::string number = std::to_string(level.number);
  return level.complete ? "after level " + number
                        : "in level " + number + ", after " +
                              std::to_string(level.path.size()) + " solved steps";
}

/// "1 thread", "2 processes with 1 thread each"
std::string processesAndThreads(int processes) {
  const std::string text = counted(threads(), "thread", "threads");
  return processes == 1
             ? text
             : counted(processes, "process", "processes") + " with " + text + " each";
}

/// The name of a file as one word of a shell that is not taken for an option.
std::string fileWord(const std::string& name) {
  return shellWord(name.rfind('-', 0) == 0 ? "./" + name : name);
}

/// What an interrupted run says; `level`: what is written last, a level or a step on the way to
/// one, or null.
std::string advice(const Given& given, const Scene& scene, const std::string& folder,
                   const Level* level) {
  if (level == nullptr)
    return "interrupted before a level was written; nothing is kept";
  if (!scene.output.fields)
    return bem::message("interrupted ", placeOf(*level), "; its files are in ", folder,
                        ", but Output->Fields = false leaves nothing to go on from");
  std::string command = "epafi run " + fileWord(given.argument);
  for (const std::string& assignment : given.values("--set"))
    command += " --set " + shellWord(assignment);
  if (given.has("--reference"))
    command += " --reference " + fileWord(given.value("--reference"));
  return bem::message("interrupted ", placeOf(*level), "; to go on from it: ", command,
                      " --restart ", fileWord(folder));
}

/// Prints warnings unless --quiet is given.
void warn(const std::vector<std::string>& warnings, bool quiet) {
  if (!quiet)
    for (const std::string& warning : warnings)
      std::cerr << "epafi: warning: " << warning << "\n";
}

/// Of the stabilised stiffness relative to the plain one, see contact::limitGamma0.
double smallestEigenvalue(const SolvedLevel& level) {
  const Scene& scene = level.last().spaces.scene();
  double smallest = 1;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const contact::Solved& solved = level.last().bodies[b];
    const double limit = contact::limitGamma0(
        {solved.space, level.stiffness[b], scene.lame(b), solved.units,
         scene.bodies[b].conditions, contact::multiplierBasis(scene.multiplier),
         scene.stabilization});
    smallest = std::min(smallest, 1 - solved.problem.coupling().gamma0 / limit);
  }
  return smallest;
}

/// Columns that the options add to history.csv.
MoreColumns moreColumns(const Given& given, const Scene& scene) {
  MoreColumns errors;
  if (given.has("--reference"))
    errors = errorsAgainst(given.value("--reference"), scene);
  const bool eigenvalue = given.has("--smallest-eigenvalue");
  return [=](const SolvedLevel* level, const LevelRow& row) {
    Cells cells = errors ? errors(level, row) : Cells();
    if (eigenvalue)
      append(cells, eigenvalueColumn());
    if (eigenvalue && level != nullptr)
      cells.back().value = smallestEigenvalue(*level);
    return cells;
  };
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
    } catch (const bem::InputError&) {  // report the first error
    }
    throwIfInterrupted();  // with the advice of what is written now
    throw;
  }
}

}  // namespace

Cells eigenvalueColumn() {
  return {{"smallest_eigenvalue", "",
           "with `--smallest-eigenvalue`: of the stabilised stiffness relative to the "
           "stiffness without stabilisation",
           "1"}};
}

int runCommand(const Given& given, std::ostream& out, const Ranks& ranks) {
  const bool quiet = given.has("--quiet");
  const std::string restart = given.value("--restart");
  const Scene scene = readScene(given.argument, given.values("--set"));
  const Beginning beginning = begin(given, scene);
  std::optional<OutputFolder> folder;  // the first rank's
  MoreColumns more;
  if (ranks.isFirst()) {
    more = moreColumns(given, scene);
    folder.emplace(beginning.folder, beginning.earlierRun);
  }
  ranks.listenToSignals();
  adviseOnInterrupt(advice(given, scene, restart,
                           beginning.earlier ? &beginning.earlier->level : nullptr));
  std::ostream silence(nullptr);
  std::ostream& table = quiet ? silence : out;
  const ProgressLine progress(ranks.isFirst() && !quiet);
  Recorder recorder(
      scene, beginning.earlier, folder, progress, table,
      [&](const Level& level) {
        adviseOnInterrupt(advice(given, scene, beginning.folder, &level));
      },
      more);
  if (beginning.earlier && beginning.earlierRun != EarlierRun::Continue)
    recorder.beginWith(restart);
  table << scene.title << " (" << scene.file << "), BLAS core " << versions().blasCore
        << ", " << processesAndThreads(ranks.processes().count()) << "\n";
  if (beginning.earlier)
    table << "goes on " << placeOf(beginning.earlier->level) << " in " << restart << "\n";
  if (ranks.isFirst())
    warn(warningsOf(scene), quiet);
  table << tableHead() << std::flush;

  PhaseTimer timer([&](const std::string& phase) {
    throwIfInterrupted();
    progress.show(phase);
  });
  const auto outcome = naming(scene.file, [&] {
    return solveAndRecord(scene, beginning.earlier, ranks, timer, recorder);
  });
  progress.clear();

  const bool converged = outcome.status == contact::Status::Converged;
  const int code = converged ? Solved : NotConverged;
  if (!folder)
    return code;
  recorder.finish(timer);
  warn(recorder.warnings(), quiet);
  (converged ? table : std::cerr)
      << (converged ? "ended   " : "epafi: ") << outcome.reason << "\n";
  table << recorder.pressure() << timeSummary(timer) << filesWritten(*folder);
  return code;
}

int versionCommand(const Given&, std::ostream& out) {
  const Versions v = versions();
  out << "Epafi " << v.epafi << "\nTrilinos " << v.trilinos << "\nMPI " << v.mpi
      << "\nBLAS core " << v.blasCore << "\n";
  return 0;
}

}  // namespace epafi::drivers
