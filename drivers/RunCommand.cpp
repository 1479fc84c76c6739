#include "drivers/RunCommand.hpp"

#include "bem/base/Error.hpp"
#include "drivers/BlasCore.hpp"
#include "drivers/CommandLine.hpp"
#include "drivers/FieldFiles.hpp"
#include "drivers/Interrupt.hpp"
#include "drivers/LevelTable.hpp"
#include "drivers/Levels.hpp"
#include "drivers/OutputFolder.hpp"
#include "drivers/SceneReader.hpp"
#include "drivers/Versions.hpp"

#include <iostream>
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

/// A stream that swallows everything.
std::ostream& silence() {
  static std::ostream stream(nullptr);
  return stream;
}

}  // namespace

int runCommand(const std::vector<std::string>& arguments, std::ostream& out) {
  const RunOptions options = parseRunOptions(arguments);
  const Scene scene = readScene(options.scene, options.overrides);
  if (options.threads > 0)
    setThreads(options.threads);
  OutputFolder folder(
      options.output.empty() ? defaultOutputFolder(options.scene) : options.output,
      options.force ? EarlierRun::Delete : EarlierRun::Refuse);
  catchSignals();
  folder.write("used.xml", usedXml(scene));

  std::ostream& table = options.quiet ? silence() : out;
  table << scene.title << " (" << scene.file << "), BLAS core " << versions().blasCore
        << ", " << threads() << (threads() == 1 ? " thread\n" : " threads\n")
        << tableHead() << std::flush;

  PhaseTimer timer(options.quiet || isatty(STDERR_FILENO) == 0 ? Progress::Silent
                                                               : Progress::Shown);
  std::vector<LevelRow> rows;
  Outcome outcome;
  try {
    outcome = solveLevels(scene, timer, [&](const SolvedLevel& level) {
      rows.push_back(level.row);
      writeLevel(scene, level, rows, folder);
      timer.clearLine();
      table << tableLine(level.row) << std::flush;
    });
  } catch (...) {
    folder.write("timings.txt", timer.report());
    throw;
  }
  folder.write("timings.txt", timer.report());

  const bool converged = outcome.status == contact::Status::Converged;
  (converged ? table : std::cerr)
      << (converged ? "ended   " : "epafi: ") << outcome.reason << "\n";
  table << timeSummary(timer) << filesWritten(folder);
  return converged ? 0 : 3;
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
