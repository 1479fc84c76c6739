#pragma once

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// What to do with the files of an earlier run in the same folder.
enum class EarlierRun { Refuse, Delete, Continue };

/// The folder that a run writes into.
///
/// Files appear as a whole: they are written under temporary names, stage(), and when all are,
/// renamed one after the other, commit(), so that what goes wrong while writing leaves the earlier
/// files as they are.
class OutputFolder {
 public:
  /// Makes the folder and its parents; removes what an interrupted run has left staged, and
  /// what is left of a run or a study that has not solved a level.
  /// \throws bem::InputError if an earlier run's files are there and must not be touched,
  /// if the path is a file, if nothing can be written there, or if another run does now.
  OutputFolder(std::string path, EarlierRun earlier);
  /// Removes what is staged.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// \throws bem::InputError if the file cannot be written (disk full, permissions); then
  /// nothing is staged any more.
  void stage(const std::string& name, const std::string& text);

  /// The staged files take the places of the earlier ones, in the order of staging.
  /// \throws bem::InputError if a file cannot be renamed.
  void commit();

  /// Both for one file.
  void write(const std::string& name, const std::string& text);

  /// Deletes an earlier run's file that this run does not write.
  void drop(const std::string& name) const;
  /// Deletes fields and pictures that other commands have made of a solution which is no longer
  /// the folder's.
  void dropMade() const;

  const std::string& path() const { return path_; }
  /// Names of the files written so far.
  const std::vector<std::string>& written() const { return written_; }

 private:
  void discard();

  std::string path_;
  std::shared_ptr<const void> lock_;  ///< keeps other runs out
  std::vector<std::string> staged_;
  std::vector<std::string> written_;
};

/// ./<scene file without folder and extension>.out
std::string defaultOutputFolder(const std::string& sceneFile);

}  // namespace epafi::drivers
