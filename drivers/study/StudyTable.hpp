#pragma once

#include "drivers/output/HistoryTables.hpp"
#include "drivers/study/Study.hpp"
#include "drivers/study/TrueError.hpp"

#include <optional>

namespace epafi::drivers {

/// Results of a study on a level that are not in history.csv.
struct StudiedLevel {
  std::optional<TrueError> error;
  bool counted = false;  ///< largest error >= ten times the reference's estimate
  double estimate = 0;
  double sweepValue = std::numeric_limits<double>::quiet_NaN();  ///< see Variant
  double smallestEigenvalue = std::numeric_limits<double>::quiet_NaN();
  std::string reason;  ///< empty when converged
  std::string folder;  ///< of the variant's files, relative to the study's
};

/// study.csv: scene, variant, the columns of history.csv, then
///
///   error, error_multiplier, error_energy     relative, see TrueError
///   counted                                   1 if error >= 10 estimates of the reference
///   effectivity                               estimate over the absolute energy-norm error
///   error_path, error_path_multiplier, error_path_friction, worst_step
///                                             on a path, see TrueError::Path
///   sweep_value, smallest_eigenvalue, reason
///   folder                                    of the variant, in the study's
///
/// seconds_total is the CPU time of the variant without the computation of errors.
/// Unknown values are empty.  A variant that failed has the status "failed" and the
/// reason.
class StudyTable {
 public:
  void level(const std::string& scene, const Variant& variant, const LevelRow& row,
             const StudiedLevel& studied);
  void failure(const std::string& scene, const Variant& variant, int level,
               const StudiedLevel& studied);
  /// Adds the last level of the reference, from its row in history.csv.
  void reference(const std::string& scene, const CsvRow& history);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The lines that the study prints: head of the table, and a level.
std::string studyHead();
std::string studyLine(const LevelRow& row, const StudiedLevel& studied);

}  // namespace epafi::drivers
