#pragma once

#include "drivers/output/RunTables.hpp"
#include "drivers/study/Study.hpp"
#include "drivers/study/TrueError.hpp"

#include <optional>

namespace epafi::drivers {

/// What a study knows of a level beyond its row of history.csv.
struct StudiedLevel {
  std::optional<TrueError> error;
  bool counted = false;  ///< its largest is at least ten times the reference's estimate
  double smallestEigenvalue = std::numeric_limits<double>::quiet_NaN();
  std::string folder;  ///< with the variant's files, in the study's
};

/// study.csv: scene, variant, the columns of history.csv, then
///
///   error, error_multiplier, error_energy     relative, see TrueError
///   counted                                   1 if the error is far above the reference's
///   effectivity                               estimate over the absolute energy-norm error
///   error_path, error_path_multiplier, error_path_friction, worst_step
///                                             on a path, see TrueError::Path
///   sweep_value, smallest_eigenvalue, reason
///   folder                                    of the variant, in the study's
///
/// seconds_total is CPU time of the variant alone, without the computation of errors.
/// What is not known is empty; `status` of a variant that failed is "failed", with the
/// reason.
class StudyTable {
 public:
  StudyTable();

  void level(const std::string& scene, const Variant& variant, const LevelRow& row,
             const StudiedLevel& studied);
  void failure(const std::string& scene, const Variant& variant, int level,
               const std::string& reason, double smallestEigenvalue);
  /// The last level of the reference, from its cells.
  void reference(const std::string& scene, const std::vector<std::string>& cells);

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What the study prints of a level.
std::string studyHead();
std::string studyLine(const LevelRow& row, const StudiedLevel& studied);

}  // namespace epafi::drivers
