#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ChildProgram.hpp"

#include <filesystem>
#include <fstream>

namespace epafi::drivers {

namespace {

/// Runs the plotting program; returns 0 or 1.
int callPlot(const std::vector<std::string>& arguments) {
  return runPackage("plot/__main__.py", arguments, "plot") ? 0 : 1;
}

}  // namespace

int drawScene(const std::string& csv, const std::string& title, const std::string& file) {
  /// A temporary file, deleted also if drawing fails.
  struct Table {
    ~Table() {
      std::error_code ignored;
      std::filesystem::remove(file, ignored);
    }
    const std::string file;
  } const table{file + ".csv.part"};
  if (!(std::ofstream(table.file) << csv << std::flush))
    throw bem::InputError("--plot: '", file, "' cannot be written");
  return callPlot({"--scene=" + file, "--title=" + title, "--", table.file});
}

int plotCommand(const Given& given, std::ostream&) { return callPlot(given.words()); }

int reportCommand(const Given& given, std::ostream&) {
  std::vector<std::string> words = given.words();
  words.insert(words.begin(), "--report");
  return callPlot(words);
}

}  // namespace epafi::drivers
