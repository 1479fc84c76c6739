#include "bem/base/Error.hpp"
#include "contact/body/DenseBody.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/ContactTable.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/PrintedTable.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/process/Interrupt.hpp"
#include "drivers/process/ProgressLine.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"
#include "drivers/study/StudyTable.hpp"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <set>

namespace epafi::drivers {

namespace {

/// A name as the name of a file that is neither hidden nor in another folder.
std::string fileName(const std::string& name) {
  std::string result;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ||
                       c == '-' || c == '+' || c == '=';
    result += plain ? c : '_';
  }
  if (result.empty() || result.front() == '.')
    result.insert(0, "_");
  return result;
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

/// All of a level at once, with its steps.
void addTo(Checkpoint& tables, const SolvedLevel& level, const LevelRow& row) {
  if (level.level.onPath())
    for (const auto& step : level.steps)
      tables.addStep(*step);
  tables.addLevel(level, row);
  tables.take(level, level.row);
}

class StudyRun {
 public:
  StudyRun(const Study& study, OutputFolder& folder, const Ranks& ranks,
           std::ostream& out)
      : study_(study),
        folder_(folder),
        ranks_(ranks),
        out_(out),
        progress_(out.rdbuf() != nullptr) {}

  /// Solves everything; returns the number of variants that failed or did not converge.
  int run() {
    for (const StudiedScene& scene : study_.scenes) {
      const std::optional<Reference> reference = referenceOf(scene);
      out_ << studyHead();
      for (const Variant& variant : scene.variants)
        solve(scene, variant, reference);
    }
    return unsolved_;
  }

 private:
  PhaseTimer makeTimer() const {
    return PhaseTimer([this](const std::string& phase) {
      throwIfInterrupted();
      progress_.show(phase);
    });
  }

  /// The stored or newly computed reference; nothing if there is none or it failed.
  std::optional<Reference> referenceOf(const StudiedScene& scene) {
    if (!scene.reference)
      return std::nullopt;
    const std::string name = "reference-" + fileName(scene.name) + ".hdf";
    const std::string path = folder_.path() + "/" + name;
    std::optional<Checkpoint> kept = readSolutionOf(*scene.reference, path);
    const bool fresh = !kept;
    if (fresh && compute(scene, name))
      kept = readSolution(path);
    if (!kept)
      return std::nullopt;
    const CsvRow cells = rowsOf(kept->history).back();
    Reference reference(takeSnapshots(*scene.reference, kept->level, energyOf(cells),
                                      dissipatedOf(kept->steps, kept->level.number)),
                        kept->level.estimate(), *scene.reference);
    out_ << scene.name << ": reference " << (fresh ? "computed" : "kept from before")
         << ", " << kept->level.elements() << " elements, estimate " << reference.estimate
         << "\n"
         << std::flush;
    table_.reference(scene.name, cells);
    folder_.write("study.csv", table_.text());
    return reference;
  }

  /// Writes its last level, once all are solved: what stands in the folder is taken for the
  /// whole of it later.  Whether that is so; a failure is listed as of a variant.
  bool compute(const StudiedScene& scene, const std::string& name) {
    const Variant reference{"reference", *scene.reference};
    PhaseTimer timer = makeTimer();
    Checkpoint tables = Checkpoint::before(reference.scene);
    std::string last;
    int solved = 0;
    const bool whole = attempt(scene, reference, solved, [&] {
      const Outcome outcome =
          solveLevels(reference.scene, ranks_, timer, [&](const SolvedLevel& level) {
            ++solved;
            addTo(tables, level, level.row);
            last = solutionFile(reference.scene, tables, boundaryLines(level.last()));
          });
      if (outcome.status != contact::Status::Converged)
        throw bem::NumericalError("not converged: " + outcome.reason);
    });
    progress_.clear();
    if (whole)
      folder_.write(name, last);
    return whole;
  }

  /// work(), or a row of the table that says why it failed behind `solved` levels.
  template <class Work>
  bool attempt(const StudiedScene& scene, const Variant& variant, const int& solved,
               const Work& work) {
    try {
      work();
      return true;
    } catch (const contact::IndefiniteStiffness& error) {
      fail(scene, variant, solved, error.what(), 1 - error.gamma0 / error.limitGamma0);
    } catch (const bem::NumericalError& error) {
      fail(scene, variant, solved, error.what());
    } catch (const bem::InputError& error) {  // known only once there is a mesh
      fail(scene, variant, solved, error.what());
    } catch (const std::bad_alloc&) {
      fail(scene, variant, solved, "the memory does not suffice");
    }
    return false;
  }

  void solve(const StudiedScene& scene, const Variant& variant,
             const std::optional<Reference>& reference) {
    out_ << scene.name << ": " << variant.name << "\n" << std::flush;
    const std::string name = folderOf(scene, variant);
    OutputFolder own(folder_.path() + "/" + name, EarlierRun::Delete);
    Checkpoint tables = Checkpoint::before(variant.scene);
    own.write("used.xml", tables.used);
    PhaseTimer timer = makeTimer();
    double unwatched = cpuSeconds();  // before the variant, and in what is not its work
    int solved = 0;
    std::vector<std::string> ofScene;
    std::vector<std::string> ofLevel;  // the last
    attempt(scene, variant, solved, [&] {
      ofScene = warningsOf(variant.scene);
      solveLevels(variant.scene, ranks_, timer, [&](const SolvedLevel& level) {
        LevelRow row = level.row;
        const double now = cpuSeconds();
        row.secondsTotal = now - unwatched;
        addTo(tables, level, row);
        ++solved;
        note(scene, variant, reference, level, row, name);
        writeFiles(variant, level, tables, own);
        ofLevel = warningsOf(level);
        progress_.clear();
        unwatched += cpuSeconds() - now;
        if (row.report.status != contact::Status::Converged)
          ++unsolved_;  // it is the last level
      });
    });
    for (const auto* warnings : {&ofScene, &ofLevel})
      for (const std::string& warning : *warnings)
        out_ << "  warning: " << warning << "\n";
  }

  void note(const StudiedScene& scene, const Variant& variant,
            const std::optional<Reference>& reference, const SolvedLevel& level,
            const LevelRow& row, const std::string& folder) {
    StudiedLevel studied;
    studied.estimate = row.estimate;
    studied.sweepValue = variant.sweepValue;
    studied.reason = row.reason;
    studied.folder = folder;
    if (study_.smallestEigenvalue)
      studied.smallestEigenvalue = smallestEigenvalue(level);
    // a path that broke off ends under other loads
    if (reference && (!level.level.onPath() || level.last().row.converged)) {
      std::vector<double> dissipated;
      for (const auto& step : level.steps)
        dissipated.push_back(step->row.energyDissipated);
      studied.error = trueError(
          takeSnapshots(variant.scene, level.level, energyOf(cellsOf(row)), dissipated),
          *reference, variant.scene);
      studied.counted = studied.error->largest >= 10 * reference->estimate;
    }
    table_.level(scene.name, variant, row, studied);
    folder_.write("study.csv", table_.text());
    out_ << studyLine(row, studied)
         << gamma0Note(row, variant.scene.stabilization.firstGamma0())
         << operatorsNote(row) << worstStepNote(row);
    if (row.report.status != contact::Status::Converged)
      out_ << "  not converged: " << row.reason << "\n";
    out_ << std::flush;
  }

  void fail(const StudiedScene& scene, const Variant& variant, int level,
            const std::string& reason,
            double eigenvalue = std::numeric_limits<double>::quiet_NaN()) {
    ++unsolved_;
    StudiedLevel studied;
    studied.sweepValue = variant.sweepValue;
    studied.smallestEigenvalue = eigenvalue;
    studied.reason = reason;
    table_.failure(scene.name, variant, level, studied);
    folder_.write("study.csv", table_.text());
    progress_.clear();
    out_ << "  " << scene.name << ": " << variant.name << " failed on level " << level
         << ": " << reason << "\n"
         << std::flush;
  }

  /// Of sweeps, which may have hundreds of values, only contact.csv and steps.csv.
  void writeFiles(const Variant& variant, const SolvedLevel& level,
                  const Checkpoint& tables, OutputFolder& folder) const {
    const Scene& scene = variant.scene;
    if (scene.hasContact())
      folder.write("contact.csv", contactCsv(level.last()));
    if (!tables.steps.empty())
      folder.write("steps.csv", tables.steps);
    if (variant.swept && !study_.keepSolutions)
      return;
    folder.write("history.csv", tables.history);
    if (scene.tellsBodies())
      folder.write("bodies.csv", tables.bodies);
    if (!scene.output.fields)
      return;
    const VtkGrid grid = boundaryLines(level.last());
    folder.write("boundary.csv", boundaryCsv(scene, grid));
    if (study_.keepSolutions)
      folder.write("solution.hdf", solutionFile(scene, tables, grid));
  }

  /// Different variants get different folders, even if their names differ in signs only.
  std::string folderOf(const StudiedScene& scene, const Variant& variant) {
    std::string name = (variant.swept ? "sweep/" : "") +
                       (study_.scenes.size() > 1 ? fileName(scene.name) + "-" : "") +
                       fileName(variant.name);
    while (!folders_.insert(name).second)
      name += "_";
    return name;
  }

  const Study& study_;
  OutputFolder& folder_;
  const Ranks& ranks_;
  std::ostream& out_;
  ProgressLine progress_;
  StudyTable table_;
  std::set<std::string> folders_;
  int unsolved_ = 0;
};

}  // namespace

int studyCommand(const Given& given, std::ostream& out, const Ranks& ranks) {
  if (ranks.processes().count() > 1)
    throw bem::InputError(
        "study: runs on one process, so that its times mean something; --threads N uses "
        "more cores");
  const bool quiet = given.has("--quiet");
  const Study study = readStudy(given.argument);
  OutputFolder folder(given.value("--output", defaultOutputFolder(given.argument)),
                      given.has("--force") ? EarlierRun::Delete : EarlierRun::Refuse);
  ranks.listenToSignals();
  adviseOnInterrupt(bem::message("interrupted; ", folder.path(),
                                 "/study.csv has what was solved; --force begins anew "
                                 "and keeps the references that are there"));
  folder.write("used.xml", toXml(study.used, study.title));

  std::ostream silence(nullptr);
  std::ostream& text = quiet ? silence : out;
  text << study.title << ", " << counted(threads(), "thread", "threads") << "\n";
  const int unsolved = StudyRun(study, folder, ranks, text).run();
  if (unsolved > 0)
    std::cerr << "epafi: " << counted(unsolved, "variant was", "variants were")
              << " not solved on every level: column reason of " << folder.path()
              << "/study.csv\n";
  const int drawn = given.has("--no-plot")
                        ? 0
                        : drawPictures(folder.path(), quiet ? Words::Errors : Words::All);
  return unsolved > 0 ? 3 : drawn;
}

}  // namespace epafi::drivers
