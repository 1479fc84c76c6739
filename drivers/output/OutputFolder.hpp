#pragma once

#include <memory>
#include <string>
#include <vector>

namespace epafi::drivers {

/// What to do with the files of an earlier run in the same folder.
enum class EarlierRun { Refuse, Delete, Continue };

/// The path of a file in a folder, which may be somebody else's.
/// \throws bem::InputError where a link leads out of the folder.
std::string ownFile(const std::string& folder, const std::string& name);

/// The folder into which a run writes its files.
///
/// Files are replaced as a whole: stage() writes all of them under temporary names,
/// commit() renames them one after the other.  If writing fails, the earlier files remain
/// unchanged.
class OutputFolder {
 public:
  /// Creates the folder and its parents.  Removes files that an interrupted run has
  /// staged, and the files of an earlier run or study that solved no level.
  /// \throws bem::InputError if the folder holds an earlier run that must be kept, if the
  ///   path is a file, if it is not writable, or if another run is writing there.
  OutputFolder(std::string path, EarlierRun earlier);
  /// Removes all staged files.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// \throws bem::InputError if the file cannot be written (disk full, permissions); then
  ///   no file remains staged.
  void stage(const std::string& name, const std::string& text);

  /// Replaces the earlier files by the staged ones, in the order of staging.
  /// \throws bem::InputError if a file cannot be renamed.
  void commit();

  /// Stages and commits one file.
  void write(const std::string& name, const std::string& text);

  /// Deletes a file of an earlier run that this run does not write.
  void drop(const std::string& name) const;
  /// Deletes the files of later steps, of a level before on which the path went on.
  void dropStepsBehind(std::size_t last) const;
  /// Deletes the fields and pictures that other commands derived from the earlier
  /// solution.
  void dropMade() const;

  const std::string& path() const { return path_; }
  /// Names of the files written so far.
  const std::vector<std::string>& written() const { return written_; }

 private:
  void discard();

  std::string path_;
  std::shared_ptr<const void> lock_;  ///< lock against other runs
  std::vector<std::string> staged_;
  std::vector<std::string> written_;
};

/// ./<scene file without folder and extension>.out
std::string defaultOutputFolder(const std::string& sceneFile);

}  // namespace epafi::drivers
