#include "drivers/output/OutputFolder.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Inside.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

/// All files that a run may write; only these and files derived from them are deleted.
constexpr const char* outputFiles[] = {"history.csv",  "steps.csv",  "contact.csv",
                                       "boundary.csv", "bodies.csv", "interior.csv",
                                       "solution.hdf", "used.xml",   "timings.txt",
                                       "study.csv",    "steps.pvd"};

/// Files that `epafi fields` and `epafi plot` derive from them, beside pictures.
constexpr const char* madeFiles[] = {"fields.csv", "fields.vtu", "fields-window.csv",
                                     "fields.pvd", "movie.gif",  "report.html"};

/// Names of pictures (.png, .svg, .pdf) beside those of fields.       [python/epafi/plot]
constexpr const char* pictures[] = {
    "convergence",   "time",           "contributions", "mesh",  "deformed",
    "contact",       "path",           "rigid",         "steps", "contact_stress",
    "effectivity",   "work-precision", "exponential",   "sweep", "sweep_forces",
    "sweep_contact", "sweep_column",   "slip",          "scene"};

template <class Names>
bool isAmong(const Names& names, const std::string& name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool isMade(const std::string& name) {
  const fs::path file = name;
  if (file.extension() != ".png" && file.extension() != ".svg" &&
      file.extension() != ".pdf")
    return isAmong(madeFiles, name);
  std::string stem = file.stem().string();
  const std::string numbered = "sweep_contact_";
  if (stem.rfind(numbered, 0) == 0 &&
      stem.find_first_not_of("0123456789", numbered.size()) == std::string::npos)
    stem = "sweep_contact";
  return isAmong(pictures, stem) || isAmong(fieldNames(), stem);
}

/// Deletes a file, or a folder that is empty, if it can.
void deleteQuietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

/// The derived files that a folder contains.
std::vector<std::string> madeIn(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path, ignored))
    if (isMade(entry.path().filename().string()) && !entry.is_directory(ignored))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// All files of an earlier run that a folder contains.
std::vector<std::string> filesIn(const fs::path& path) {
  std::vector<std::string> names;
  for (const char* name : outputFiles) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(path / name, error)))
      names.emplace_back(name);
  }
  const std::vector<std::string> made = madeIn(path);
  names.insert(names.end(), made.begin(), made.end());
  return names;
}

/// The temporary path of a staged file.
std::string temporaryFile(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / name;
  return (file.parent_path() / ("." + file.filename().string() + ".part")).string();
}

void makeFolder(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw bem::InputError("--output: '", path.string(),
                          "' is a file; the results need a folder");
  fs::create_directories(path, error);
  if (error)
    throw bem::InputError("--output: the folder '", path.string(),
                          "' cannot be made: ", error.message());
}

/// Does a table of levels have a row below its head?
bool hasRows(const fs::path& table) {
  std::ifstream stream(table);
  std::string line;
  std::getline(stream, line);
  return std::getline(stream, line) && !line.empty();
}

/// Is there more than used.xml, timings.txt and tables without rows?  A run that ended
/// before its first level was solved leaves only these; they need not be kept.
bool holdsSolvedLevel(const fs::path& path) {
  for (const std::string& name : filesIn(path)) {
    const bool table = name == "history.csv" || name == "study.csv";
    const fs::path file = path / name;
    std::error_code error;
    if (name == "used.xml" || name == "timings.txt")
      continue;
    if (!table || !fs::is_regular_file(file, error) || hasRows(file))
      return true;
  }
  return false;
}

[[noreturn]] void refuseEarlier(const fs::path& path, const std::string& name) {
  std::error_code error;
  const bool isStudy = fs::exists(path / "study.csv", error);
  throw bem::InputError("--output: the folder '", path.string(), "' holds an earlier ",
                        isStudy ? "study (" : "run (", name, "); ",
                        isStudy ? "--force replaces it and keeps its references"
                                : "--restart DIR goes on from it, --force replaces it",
                        ", --output DIR goes elsewhere");
}

/// Deletes the files of a run in steps/<k>, k > last, and those folders that are empty then.
void deleteSteps(const fs::path& path, std::size_t last) {
  std::error_code ignored;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(ownFile(path, "steps"), ignored))
    folders.push_back(entry.path());
  for (const fs::path& folder : folders) {
    const std::string name = folder.filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos ||
        std::strtoul(name.c_str(), nullptr, 10) <= last)
      continue;
    for (const char* file : {"contact.csv", "boundary.vtu", "fields.vtu"}) {
      deleteQuietly(ownFile(path, "steps/" + name + "/" + file));
      deleteQuietly(temporaryFile(folder, file));
    }
    deleteQuietly(folder);
  }
  deleteQuietly(path / "steps");
}

void deleteEarlierRun(const fs::path& path, EarlierRun earlier) {
  for (const char* name : outputFiles)
    deleteQuietly(temporaryFile(path, name));
  if (earlier == EarlierRun::Continue)
    return;
  if (earlier == EarlierRun::Delete)
    deleteSteps(path, 0);
  const bool refuse = earlier == EarlierRun::Refuse && holdsSolvedLevel(path);
  for (const std::string& name : filesIn(path)) {
    const fs::path file = path / name;
    std::error_code error;
    if (refuse)
      refuseEarlier(path, name);
    if (fs::is_directory(file, error) || !fs::remove(file, error))
      throw bem::InputError("--output: '", file.string(),
                            "' of an earlier run cannot be deleted: ",
                            error ? error.message() : "it is a folder");
  }
}

[[noreturn]] void refuse(const fs::path& file, const std::string& cause) {
  throw bem::InputError(
      bem::message("--output: '", file.string(), "' cannot be written: ", cause));
}

/// Locks a folder against other runs, also of other processes, while the result exists, or
/// what this process becomes.
/// Does nothing on a file system without locks.
/// \throws bem::InputError if another run has locked the folder.
std::shared_ptr<const void> locked(const std::string& path) {
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY);
  if (folder < 0)
    return nullptr;
  const std::shared_ptr<const int> lock(new int(folder), [](const int* open) {
    close(*open);
    delete open;
  });
  if (flock(folder, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw bem::InputError(bem::message("--output: another run writes into the folder '",
                                       path, "' now; --output DIR goes elsewhere"));
  return lock;
}

}  // namespace

std::string ownFile(const std::string& folder, const std::string& name) {
  const fs::path file = fs::path(folder) / name;
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(file, ignored);
  const fs::path inside = real.lexically_relative(fs::weakly_canonical(folder, ignored));
  const bool dangles = fs::is_symlink(file, ignored) && !fs::exists(file, ignored);
  if (inside.empty() || *inside.begin() == ".." || dangles)
    throw bem::InputError(
        "'", file.string(), "' is a link out of its folder, to '",
        dangles ? fs::read_symlink(file, ignored).string() : real.string(),
        "'; what is read and written is in the folder itself");
  return file.string();
}

OutputFolder::OutputFolder(std::string path, EarlierRun earlier)
    : path_(std::move(path)) {
  makeFolder(path_);
  lock_ = locked(path_);
  deleteEarlierRun(path_, earlier);
  // Fail now rather than after hours of computing.
  const fs::path probe = ownFile(path_, ".epafi.probe");
  errno = 0;
  if (!std::ofstream(probe))
    refuse(probe.parent_path(), std::strerror(errno));
  fs::remove(probe);
}

OutputFolder::~OutputFolder() { discard(); }

void OutputFolder::stage(const std::string& name, const std::string& text) {
  if (const fs::path inside = fs::path(name).parent_path(); !inside.empty())
    makeFolder(ownFile(path_, inside));
  deleteQuietly(temporaryFile(path_, name));  // a link there would be followed
  staged_.push_back(name);
  errno = 0;
  std::ofstream stream(temporaryFile(path_, name), std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  if (stream)
    return;
  const std::string cause = std::strerror(errno);
  discard();
  refuse(fs::path(path_) / name, cause);
}

void OutputFolder::commit() {
  for (const std::string& name : staged_) {
    const fs::path file = fs::path(path_) / name;
    std::error_code error;
    fs::rename(temporaryFile(path_, name), file, error);
    if (error) {
      discard();
      refuse(file, error.message());
    }
    if (!isAmong(written_, name))
      written_.push_back(name);
  }
  staged_.clear();
}

void OutputFolder::write(const std::string& name, const std::string& text) {
  stage(name, text);
  commit();
}

void OutputFolder::drop(const std::string& name) const {
  deleteQuietly(fs::path(path_) / name);
}

void OutputFolder::dropStepsBehind(std::size_t last) const { deleteSteps(path_, last); }

void OutputFolder::dropMade() const {
  for (const std::string& name : madeIn(path_))
    drop(name);
}

void OutputFolder::discard() {
  for (const std::string& name : staged_)
    deleteQuietly(temporaryFile(path_, name));
  staged_.clear();
}

std::string defaultOutputFolder(const std::string& sceneFile) {
  return "./" + fs::path(sceneFile).stem().string() + ".out";
}

}  // namespace epafi::drivers
