#include "drivers/OutputFolder.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

void makeFolder(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw bem::InputError(bem::message("--output: '", path.string(),
                                       "' is a file; the results need a folder"));
  fs::create_directories(path, error);
  if (error)
    throw bem::InputError(bem::message("--output: the folder '", path.string(),
                                       "' cannot be made: ", error.message()));
}

void deleteEarlierRun(const fs::path& path, EarlierRun earlier) {
  for (const std::string& name : outputFiles()) {
    const fs::path file = path / name;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(file, error)))
      continue;
    if (earlier == EarlierRun::Refuse)
      throw bem::InputError(bem::message(
          "--output: the folder '", path.string(), "' holds an earlier run (", name,
          "); --force replaces it, --output DIR goes elsewhere"));
    if (fs::is_directory(file, error) || !fs::remove(file, error))
      throw bem::InputError(bem::message("--output: '", file.string(),
                                         "' of an earlier run cannot be deleted: ",
                                         error ? error.message() : "it is a folder"));
  }
}

[[noreturn]] void refuse(const fs::path& file, int cause) {
  throw bem::InputError(bem::message("--output: '", file.string(),
                                     "' cannot be written: ", std::strerror(cause)));
}

}  // namespace

OutputFolder::OutputFolder(std::string path, EarlierRun earlier)
    : path_(std::move(path)) {
  makeFolder(path_);
  deleteEarlierRun(path_, earlier);
  // Better now than after hours of computing.
  const fs::path probe = fs::path(path_) / ".epafi.probe";
  errno = 0;
  if (!std::ofstream(probe))
    refuse(probe.parent_path(), errno);
  fs::remove(probe);
}

void OutputFolder::write(const std::string& name, const std::string& text) {
  const fs::path file = fs::path(path_) / name;
  const fs::path temporary = fs::path(path_) / ("." + name + ".part");
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (!stream) {
    const int cause = errno;
    std::error_code ignored;
    fs::remove(temporary, ignored);
    refuse(file, cause);
  }
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error)
    refuse(file, error.value());
  if (std::find(written_.begin(), written_.end(), name) == written_.end())
    written_.push_back(name);
}

const std::vector<std::string>& outputFiles() {
  static const std::vector<std::string> names = {
      "history.csv",  "contact.csv", "boundary.csv", "interior.csv",
      "solution.hdf", "used.xml",    "timings.txt",  "study.csv"};
  return names;
}

std::string defaultOutputFolder(const std::string& sceneFile) {
  return "./" + fs::path(sceneFile).stem().string() + ".out";
}

}  // namespace epafi::drivers
