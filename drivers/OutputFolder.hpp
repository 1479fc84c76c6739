#pragma once

#include <string>
#include <vector>

namespace epafi::drivers {

/// What to do with the files of an earlier run in the same folder.
enum class EarlierRun { Refuse, Delete };

/// The folder that a run writes into.
class OutputFolder {
 public:
  /// Makes the folder and its parents.
  /// \throws bem::InputError if an earlier run's files are there and must not be deleted,
  /// if
  ///   the path is a file, or if nothing can be written there.
  OutputFolder(std::string path, EarlierRun earlier);

  /// Replaces a file as a whole: written under a temporary name, then renamed.
  /// \throws bem::InputError if it cannot be written (disk full, permissions).
  void write(const std::string& name, const std::string& text);

  const std::string& path() const { return path_; }
  /// Names of the files written so far.
  const std::vector<std::string>& written() const { return written_; }

 private:
  std::string path_;
  std::vector<std::string> written_;
};

/// All files that a run may write; only these are ever deleted.  [design.md 1.4]
const std::vector<std::string>& outputFiles();

/// ./<scene file without folder and extension>.out
std::string defaultOutputFolder(const std::string& sceneFile);

}  // namespace epafi::drivers
