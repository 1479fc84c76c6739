#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ChildProgram.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

// Debian's own: matplotlib belongs to it, whatever else PATH may offer first.
constexpr const char* python = "/usr/bin/python3";

/// The plotting program with arguments; its exit code, 0 or 1.
int callPlot(std::vector<std::string> arguments) {
  const std::string program = besideProgram(EPAFI_PYTHON "/epafi/plot/__main__.py");
  if (!fs::exists(program))
    throw bem::InputError(
        "plot: '", program,
        "' is missing; it is built and installed along with this program");
  arguments.insert(arguments.begin(), program);
  std::cout << std::flush;
  return runChild(python, std::move(arguments), "plot", "install python3") ? 0 : 1;
}

}  // namespace

int drawPictures(const std::string& folder, Words words,
                 const std::vector<std::string>& more) {
  std::vector<std::string> texts = {folder};
  if (words == Words::Errors)
    texts.emplace_back("--quiet");
  texts.insert(texts.end(), more.begin(), more.end());
  return callPlot(texts);
}

int drawScene(const std::string& csv, const std::string& title, const std::string& file) {
  /// Gone with the scope, also where nothing can be drawn.
  struct Table {
    ~Table() {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
    const std::string file;
  } const table{file + ".csv.part"};
  if (!(std::ofstream(table.file) << csv << std::flush))
    throw bem::InputError("--plot: '", file, "' cannot be written");
  return callPlot({table.file, "--scene", file, "--title=" + title});
}

int plotCommand(const Given& given, std::ostream&) {
  if (!given.has("--field")) {
    for (const char* option : {"--window", "--step"})
      if (given.has(option))
        throw bem::InputError(option, " belongs to a --field");
    return drawPictures(given.argument, Words::All);
  }
  if (given.has("--window"))
    writeWindow(given.argument, given.value("--step", ""), given.value("--window"));
  else
    writeInside(given.argument, given.value("--step", ""));
  std::vector<std::string> more = {"--field=" + given.value("--field")};
  if (given.has("--window"))
    more.emplace_back("--window");
  return drawPictures(given.argument, Words::All, more);
}

}  // namespace epafi::drivers
