#pragma once

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/output/PathContactTable.hpp"
#include "drivers/output/Restart.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/process/ProgressLine.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Takes the levels of a run as they are solved: as lines of the table, and into the files of
/// the folder, which the first process alone has; `written` is told the level, or the step on the
/// way to one, whose files these are.
class Recorder {
 public:
  Recorder(const Scene& scene, const std::optional<Checkpoint>& earlier,
           std::optional<OutputFolder>& folder, const ProgressLine& progress,
           std::ostream& table, std::function<void(const Level&)> written);

  /// A solved level; its files are written now or, if they were written a moment ago, later.
  void take(const SolvedLevel& level);
  /// A step on the way to a level: what a run that is killed goes on from once it is written, now
  /// or later likewise, unless the earlier run has left more.
  void takeStep(const SolvedLevel& level);
  /// The files of the level and the step taken last, if they wait: they take the place of those
  /// before, which a restart begins with last.
  /// \throws bem::InputError for a file that cannot be written.
  void write();
  /// What is written once, from the last level that there is.
  void finish(PhaseTimer& timer);
  void writeTimings(PhaseTimer& timer);

  int levels() const { return levels_; }
  /// Of the last level.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  /// What the steps of a level leave in files.
  struct PathRecord {
    std::vector<std::string> contacts{};    ///< contact.csv
    std::vector<std::string> boundaries{};  ///< boundary.vtu
    std::vector<double> times{};
    std::vector<PathPoint> points{};  ///< that led to these steps
  };

  /// What a solved level leaves in files, good after its operators are gone.
  struct LevelFiles {
    std::string bodies;
    PathRecord path;
    std::string contact{};
    BoundaryLines grid{};
    LevelRow row{};
  };

  /// What a step leaves in the file that grows with all of them.
  struct StepFiles {
    Level level;
    LevelRow row;
    BoundaryLines grid;  ///< empty without Fields
  };

  void stage(const LevelFiles& files);
  std::string solution(const Level& level, const LevelRow& row,
                       const BoundaryLines& grid) const;
  /// The row with the earlier run's seconds.
  LevelRow countedOn(LevelRow row) const;
  void note(const SolvedLevel& level);
  /// Is the last step one that the earlier run went beyond?  Its files would replace more.
  bool isKnown(const Level& level) const;
  /// Has what waits for its files waited long enough?
  bool isDue() const;

  const Scene& scene_;
  const std::optional<Checkpoint>& earlier_;
  std::optional<OutputFolder>& folder_;
  const ProgressLine& progress_;
  std::ostream& table_;
  std::function<void(const Level&)> written_;
  std::string used_;
  std::string history_;
  std::string bodies_;  ///< bodies.csv of all levels so far
  std::string steps_;   ///< likewise steps.csv
  PathRecord path_;     ///< of the level that is solved now
  PathContact contact_;
  std::string stages_ = "\nSolver stages, steps, how they ended\n";
  std::optional<Level> last_;
  std::optional<LevelFiles> waiting_;     ///< of the last level, until they are written
  std::optional<StepFiles> waitingStep_;  ///< likewise, of a step behind it
  double writtenAt_ = cpuSeconds();
  double writingTook_ = 0;
  std::vector<std::string> warnings_;
  std::vector<std::string> told_;  ///< likewise, of all levels
  int levels_ = 0;
};

}  // namespace epafi::drivers
