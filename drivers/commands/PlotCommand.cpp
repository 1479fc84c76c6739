#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/process/ChildProgram.hpp"
#include "drivers/run/Warnings.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace epafi::drivers {

namespace {

namespace fs = std::filesystem;

/// Runs the plotting program; returns 0 or 1.
int callPlot(const std::vector<std::string>& arguments) {
  return runPackage("plot/__main__.py", arguments, "plot") ? 0 : 1;
}

/// The given options of `looks`.
std::vector<std::string> looksOf(const Given& given) {
  std::vector<std::string> texts;
  for (const auto& [name, value, meaning, offer, words, repeatable] : looks())
    if (given.has(name))
      texts.push_back(name + (value.empty() ? "" : "=" + given.value(name)));
  return texts;
}

/// Draws the pictures of a run's or a study's folder.
int drawPictures(const std::string& folder, std::vector<std::string> more) {
  more.insert(more.begin(), folder);
  return callPlot(more);
}

}  // namespace

int drawScene(const std::string& csv, const std::string& title, const std::string& file,
              Words words) {
  /// A temporary file, deleted also if drawing fails.
  struct Table {
    ~Table() {
      std::error_code ignored;
      fs::remove(file, ignored);
    }
    const std::string file;
  } const table{file + ".csv.part"};
  if (!(std::ofstream(table.file) << csv << std::flush))
    throw bem::InputError("--plot: '", file, "' cannot be written");
  std::vector<std::string> texts = {table.file, "--scene", file, "--title=" + title};
  if (words == Words::Errors)
    texts.emplace_back("--quiet");
  return callPlot(texts);
}

int plotCommand(const Given& given, std::ostream&) {
  std::vector<std::string> more = looksOf(given);
  const bool window = given.has("--window");
  const std::string step = given.value("--step", "");
  if (!given.has("--field") && given.has("--step"))
    throw bem::InputError("--step belongs to a --field");
  if (window)
    more.push_back("--window=" + given.value("--window"));
  if (given.has("--field")) {
    if (step == everyStep || !window)
      writeInside(given.argument, step);
    if (window)
      writeWindow(given.argument, step == everyStep ? "" : step, given.value("--window"));
    more.push_back("--field=" + given.value("--field"));
    if (step == everyStep)
      more.emplace_back("--film");
    else if (!step.empty())
      more.push_back("--step=" + step);
  } else if (window) {
    checkWindow(given.value("--window"));
  }
  return drawPictures(given.argument, std::move(more));
}

int reportCommand(const Given& given, std::ostream&) {
  const std::string& folder = given.argument;
  if (!fs::exists(folder + "/history.csv"))
    throw bem::InputError(
        "report: '", folder,
        "' holds no history.csv; the folder of a finished run is needed");
  const std::string page = given.value("--output", folder + "/report.html");
  const fs::path place = fs::path(page).parent_path();
  if (page == "-")
    throw bem::InputError("--output: a report is a file; '-' is none");
  if (!place.empty() && !fs::is_directory(place))
    throw bem::InputError("--output: there is no folder '", place.string(), "'");
  const Scene scene = readScene(folder + "/used.xml", {});
  if (drawScene(sceneCsv(scene), scene.title, folder + "/scene.png", Words::Errors) != 0)
    return 1;
  writeInside(folder, "");
  std::vector<std::string> more = looksOf(given);
  more.push_back("--field=" + given.value("--field", "von_mises"));
  more.push_back("--report=" + page);
  for (const std::string& warning : warningsOf(scene))
    more.push_back("--warning=" + warning);
  return drawPictures(folder, std::move(more));
}

}  // namespace epafi::drivers
