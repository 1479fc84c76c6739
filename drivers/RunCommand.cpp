#include "drivers/RunCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/BlasCore.hpp"
#include "drivers/CommandLine.hpp"
#include "drivers/FieldFiles.hpp"
#include "drivers/Interrupt.hpp"
#include "drivers/LevelTable.hpp"
#include "drivers/Levels.hpp"
#include "drivers/OutputFolder.hpp"
#include "drivers/Ranks.hpp"
#include "drivers/SceneReader.hpp"
#include "drivers/Versions.hpp"

#include <algorithm>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace epafi::drivers {

namespace {

/// The files of a level; those of the level before are replaced.
void writeLevel(const Scene& scene, const SolvedLevel& level,
                const std::vector<LevelRow>& rows, OutputFolder& folder) {
  folder.write("history.csv", historyCsv(rows));
  if (!scene.conditions.contact.empty())
    folder.write("contact.csv", contactCsv(level.solved, scene.output.contactSamples));
  if (scene.output.fields)
    folder.write("boundary.csv", boundaryCsv(level.solved, level.density));
  if (!scene.output.interiorPoints.empty())
    folder.write("interior.csv", interiorCsv(level.solved, level.density, scene.material,
                                             scene.output.interiorPoints));
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

}  // namespace

int runCommand(const std::vector<std::string>& arguments, std::ostream& out,
               const Ranks& ranks) {
  const RunOptions options = parseRunOptions(arguments);
  const Scene scene = readScene(options.scene, options.overrides);
  if (options.threads > 0 || ranks.underMpirun())
    setThreads(std::max(options.threads, 1));
  std::optional<OutputFolder> folder;  // the first rank's
  if (ranks.isFirst())
    folder.emplace(
        options.output.empty() ? defaultOutputFolder(options.scene) : options.output,
        options.force ? EarlierRun::Delete : EarlierRun::Refuse);
  catchSignals();
  if (folder)
    folder->write("used.xml", usedXml(scene));

  std::ostream silence(nullptr);
  std::ostream& table = options.quiet ? silence : out;
  table << scene.title << " (" << scene.file << "), BLAS core " << versions().blasCore
        << ", " << processesAndThreads(ranks.algebra().processes()) << "\n"
        << tableHead() << std::flush;

  const bool shown = ranks.isFirst() && !options.quiet && isatty(STDERR_FILENO) != 0;
  PhaseTimer timer(shown ? Progress::Shown : Progress::Silent);
  std::vector<LevelRow> rows;
  Outcome outcome;
  try {
    outcome = solveLevels(scene, ranks, timer, [&](const SolvedLevel& level) {
      if (!folder)
        return;
      rows.push_back(level.row);
      writeLevel(scene, level, rows, *folder);
      timer.clearLine();
      table << tableLine(level.row) << std::flush;
    });
  } catch (...) {
    if (folder)
      folder->write("timings.txt", timer.report());
    throw;
  }

  const bool converged = outcome.status == contact::Status::Converged;
  const int code = converged ? 0 : 3;
  if (!folder)
    return code;
  folder->write("timings.txt", timer.report());
  (converged ? table : std::cerr)
      << (converged ? "ended   " : "epafi: ") << outcome.reason << "\n";
  table << timeSummary(timer) << filesWritten(*folder);
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
