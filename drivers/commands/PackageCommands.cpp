#include "bem/base/Error.hpp"
#include "drivers/commands/Commands.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/process/ChildProgram.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/process/Threads.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Text.hpp"

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
  struct Temporary {
    ~Temporary() {
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

namespace {

using bem::Row;
using Teuchos::ParameterList;

void addOverrides(std::vector<Parameter>& table, const std::string& parent) {
  append(table,
         {Row("Set", Kind::Names, "list of 'A->B->Key=value', as for --set"),
          Row("Override", Kind::Free,
              "a piece of a scene whose values replace the scene's")},
         parent);
}

std::vector<Parameter> makeStudyParameters() {
  std::vector<Parameter> table;
  const std::string scene = "Scenes-><scene>";
  const std::string variant = "Variants-><variant>";
  addOverrides(table, "");
  append(table, {
                    Row("Smallest Eigenvalue", Kind::Flag,
                        "add the smallest eigenvalue of the stabilised stiffness "
                        "relative to the plain one")
                        .defaultValue("false"),
                    Row("Keep Solutions", Kind::Flag,
                        "write history.csv, boundary.csv and solution.hdf of every "
                        "variant, of sweeps too, as `epafi fields` wants them")
                        .defaultValue("false"),
                    Row("Scenes", Kind::List, "the scenes that are solved").required(),
                    Row(scene, Kind::List, "a scene, under a name of your choice"),
                    Row(scene + "->File", Kind::Text,
                        "the scene's file, relative to the study's")
                        .required(),
                });
  addOverrides(table, scene);
  table.push_back(Row(scene + "->Reference", Kind::List,
                      "an overkill variant, computed once and kept, that true errors are "
                      "measured against"));
  addOverrides(table, scene + "->Reference");
  append(table, {
                    Row("Variants", Kind::List, "the ways of solving them").required(),
                    Row(variant, Kind::List, "a variant, under a name of your choice"),
                    Row(variant + "->Scenes", Kind::Names,
                        "the scenes that it is for; without it all"),
                });
  addOverrides(table, variant);
  append(table, {
                    Row(variant + "->Sweep", Kind::List,
                        "one variant per value of one parameter"),
                    Row(variant + "->Sweep->Key", Kind::Text, "the parameter, A->B->Key"),
                    Row(variant + "->Sweep->Values", Kind::Names, "its values"),
                });
  return table;
}

/// The complete study as XML, with absolute paths; repeats the study.
std::string readStudy(const std::string& file) {
  namespace fs = std::filesystem;
  RawScene raw = rawScene(readText(file), file);
  if (raw.list.isSublist("Bodies"))
    throw bem::InputError("is a scene, not a study; to solve it: epafi run " + file);
  ParameterList list = bem::complete(studyParameters(), raw.list, raw.title);
  for (const auto& item : list.sublist("Scenes")) {
    const std::string& name = item.first;
    ParameterList& scene = list.sublist("Scenes").sublist(name);
    const fs::path path = fs::path(file).parent_path() / scene.get<std::string>("File");
    scene.set("File", fs::absolute(path.lexically_normal()).string());
    // The schema adds missing lists, so only the file shows whether there is a reference.
    if (!raw.list.sublist("Scenes").sublist(name).isSublist("Reference"))
      scene.remove("Reference");
  }
  return toXml(list, raw.title);
}

}  // namespace

const std::vector<Parameter>& studyParameters() {
  static const std::vector<Parameter> table = makeStudyParameters();
  return table;
}

int studyCommand(const Given& given, std::ostream&, const Ranks& ranks) {
  if (ranks.underMpirun())
    throw bem::InputError(
        "study: runs without mpirun, so that its times mean something; --threads N uses "
        "more cores");
  const std::string& file = given.argument;
  const std::string used = within(file + ": ", [&] { return readStudy(file); });
  OutputFolder folder(given.value("--output", defaultOutputFolder(file)),
                      given.has("--force") ? EarlierRun::Continue : EarlierRun::Refuse);
  folder.stage("used.xml", used);  // named so once all scenes are found to be valid
  std::vector<std::string> arguments = {file, folder.path(),
                                        counted(threads(), "thread", "threads")};
  if (given.has("--threads"))
    arguments.push_back("--threads=" + given.value("--threads"));
  for (const char* flag : {"--quiet", "--no-plot"})
    if (given.has(flag))
      arguments.emplace_back(flag);
  becomePackage("study.py", std::move(arguments), "study");
}

}  // namespace epafi::drivers
