#pragma once

#include "drivers/output/ContactTable.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/output/TrueError.hpp"
#include "drivers/output/VtkGrid.hpp"
#include "drivers/process/PhaseTimer.hpp"

#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Records the levels of a run: prints table rows, and writes the files of the folder
/// (first process only).  `written` is called with the level or step whose files were
/// written; history.csv, not solution.hdf, gets the columns that `more` adds.
class Recorder {
 public:
  Recorder(const Scene& scene, const std::optional<Checkpoint>& earlier,
           std::optional<OutputFolder>& folder, const ProgressLine& progress,
           std::ostream& table, std::function<void(const Level&)> written,
           MoreColumns more);

  /// What is written until a level is taken: the files of the level that the earlier run has left
  /// in another folder.
  void beginWith(const std::string& folder);
  /// Records a level; its files are written now or, after a recent writing, later.
  void take(const SolvedLevel& level);
  /// A step on the way to a level: what a run that is killed goes on from once it is written, now
  /// or later likewise, unless the earlier run has left more.
  void takeStep(const SolvedLevel& level);
  /// The files of the level and the step taken last, if they wait: they take the place of those
  /// before, which a restart begins with last.
  /// \throws bem::InputError for a file that cannot be written.
  void write();
  /// Writes what is written once, from the last level.
  void finish(PhaseTimer& timer);
  void writeTimings(PhaseTimer& timer);

  /// pressureLine of the last level.
  const std::string& pressure() const { return told_.pressure; }
  /// Warnings of the last level.
  const std::vector<std::string>& warnings() const { return told_.warnings; }

 private:
  /// A file's name and, made when it is written, its text: what it is made from is good after
  /// the operators are gone.
  using File = std::pair<std::string, std::function<std::string()>>;

  /// With the times of the earlier run, without those of files and errors.
  LevelRow rowOf(const SolvedLevel& level) const;
  /// Does the earlier run have a later step?  Then its files must not be replaced.
  bool isKnown(const Level& level) const;
  void writeIfDue();

  /// What is written, but for the tables, until it is written.
  struct Waiting {
    std::vector<File> files{};  ///< of the last level
    std::string restored{};     ///< folder whose solution.hdf stands for that of tables_
    bool isTaken = false;       ///< has that of tables_ to be written?
  };
  /// The steps of the level that is solved now.
  struct Way {
    std::vector<File> files{};
    std::vector<double> times{};
    std::string contact{};  ///< contact.csv of the last one
    ContactTable contacts{};
  };
  /// What there is to say at the end.
  struct Told {
    std::string pressure{};
    std::vector<std::string> warnings{};   ///< of the last level
    std::vector<std::string> overlaps{};   ///< the first of it or of its path's steps
    std::vector<std::string> fallbacks{};  ///< of all levels
    std::string stages =
        "\nSolver stages, steps, how they ended; the merit before and after each step\n";
  };
  /// CPU seconds.
  struct Pace {
    double apart = cpuSeconds();  ///< what is not the solution's
    double writtenAt = apart;
    double writingTook = 0;
  };

  const Scene& scene_;
  const std::optional<Checkpoint>& earlier_;
  std::optional<OutputFolder>& folder_;
  const ProgressLine& progress_;
  std::ostream& table_;
  std::function<void(const Level&)> written_;
  MoreColumns more_;
  Table added_;                          ///< by it, to each level
  Checkpoint tables_;                    ///< with the last level or a step behind it
  std::shared_ptr<const VtkGrid> grid_;  ///< of it; without Fields empty
  Waiting waiting_;
  Way way_;
  Told told_;
  Pace pace_;
};

}  // namespace epafi::drivers
