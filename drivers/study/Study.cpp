#include "drivers/study/Study.hpp"

#include "bem/base/Error.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::Row;
using Teuchos::ParameterList;

const char* const settings = "list of 'A->B->Key=value', as for --set";
const char* const override = "a piece of a scene whose values replace the scene's";

std::vector<std::string> namesOf(const ParameterList& list, const std::string& key) {
  return list.isParameter(key) ? list.get<Teuchos::Array<std::string>>(key).toVector()
                               : std::vector<std::string>();
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// The assignments of Set and Override of a list.
std::vector<std::string> settingsOf(const ParameterList& list) {
  std::vector<std::string> result = namesOf(list, "Set");
  if (list.isSublist("Override"))
    append(result, assignments(list.sublist("Override")));
  return result;
}

/// Reads a scene; errors begin with the path in the study that requires it.
Scene sceneAt(const std::string& path, const std::string& file,
              const std::vector<std::string>& overrides) {
  return within(path + ": ", [&] { return readScene(file, overrides); });
}

/// The variants of one entry of the study on one scene: one, or one per value of its
/// sweep.
std::vector<Variant> variantsOf(const std::string& name, const ParameterList& list,
                                const std::string& file,
                                std::vector<std::string> overrides) {
  const std::string path = "Variants->" + name;
  append(overrides, settingsOf(list));
  const ParameterList& sweep = list.sublist("Sweep");
  const std::vector<std::string> values = namesOf(sweep, "Values");
  if (sweep.isParameter("Key") == values.empty())
    throw InputError(path + "->Sweep: give both Key and Values");
  if (values.empty())
    return {{name, sceneAt(path, file, overrides)}};
  std::vector<Variant> variants;
  const auto key = sweep.get<std::string>("Key");
  for (const std::string& value : values) {
    std::vector<std::string> with = overrides;
    with.push_back(bem::message(key, "=", value));
    variants.push_back({bem::message(name, ", ", bem::lastOf(key), " = ", value),
                        sceneAt(path + "->Sweep", file, with),
                        numberIn<double>(value).value_or(std::nan("")), true});
  }
  return variants;
}

/// Is the variant solved on this scene?  Without a list Scenes it is solved on all.
bool belongs(const ParameterList& variant, const std::string& scene) {
  const std::vector<std::string> only = namesOf(variant, "Scenes");
  return only.empty() || std::find(only.begin(), only.end(), scene) != only.end();
}

void checkSceneNames(const ParameterList& study) {
  std::vector<std::string> known;
  for (const auto& scene : study.sublist("Scenes"))
    known.push_back(scene.first);
  if (known.empty())
    throw InputError("Scenes: no scene is given; at least one is needed");
  if (study.sublist("Variants").begin() == study.sublist("Variants").end())
    throw InputError("Variants: no variant is given; at least one is needed");
  for (const auto& variant : study.sublist("Variants"))
    for (const std::string& name :
         namesOf(study.sublist("Variants").sublist(variant.first), "Scenes"))
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError("Variants->", variant.first, "->Scenes: there is no '", name,
                         "'", bem::suggestion(name, known));
}

std::optional<Scene> readReference(const std::string& scene, const ParameterList& list,
                                   const std::string& file,
                                   std::vector<std::string> overrides) {
  const std::string path = "Scenes->" + scene + "->Reference";
  append(overrides, settingsOf(list));
  Scene reference = sceneAt(path, file, overrides);
  if (reference.adaptivity.estimator.weights != "Energy" ||
      reference.adaptivity.estimator.residualFactor != 1)
    throw InputError(path +
                     ": its estimate says which errors can be told, and so needs "
                     "Adaptivity->Weights = Energy and Residual Factor = 1");
  return reference;
}

/// A path in a file, relative to the current folder.
std::string besides(const std::string& file, const std::string& path) {
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

Study build(const std::string& file, const RawScene& raw) {
  ParameterList list = bem::complete(studyParameters(), raw.list, raw.title);
  checkSceneNames(list);
  Study study;
  study.title = raw.title;
  study.smallestEigenvalue = list.get<bool>("Smallest Eigenvalue");
  study.keepSolutions = list.get<bool>("Keep Solutions");
  for (const auto& item : list.sublist("Scenes")) {
    const std::string& name = item.first;
    ParameterList& given = list.sublist("Scenes").sublist(name);
    const auto sceneFile = besides(file, given.get<std::string>("File"));
    given.set("File", std::filesystem::absolute(sceneFile).string());
    std::vector<std::string> common = settingsOf(list);
    append(common, settingsOf(given));
    StudiedScene scene{name, std::nullopt, {}};
    // The schema adds missing lists, so only the file shows whether there is a reference.
    if (raw.list.sublist("Scenes").sublist(name).isSublist("Reference"))
      scene.reference =
          readReference(name, given.sublist("Reference"), sceneFile, common);
    else
      given.remove("Reference");
    for (const auto& variant : list.sublist("Variants")) {
      const ParameterList& settingsList = list.sublist("Variants").sublist(variant.first);
      if (!belongs(settingsList, name))
        continue;
      for (Variant& one : variantsOf(variant.first, settingsList, sceneFile, common)) {
        const double end = one.scene.endOfPath();
        if (scene.reference && end != scene.reference->endOfPath())
          throw InputError("Variants->", one.name, ": its path ends at t = ", end,
                           ", that of Scenes->", name, "->Reference at ",
                           scene.reference->endOfPath(),
                           "; errors compare solutions under the same loads");
        scene.variants.push_back(std::move(one));
      }
    }
    study.scenes.push_back(std::move(scene));
  }
  study.used = list;
  return study;
}

void addOverrides(std::vector<Parameter>& table, const std::string& parent) {
  append(table,
         {Row("Set", Kind::Names, settings), Row("Override", Kind::Free, override)},
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

}  // namespace

const std::vector<Parameter>& studyParameters() {
  static const std::vector<Parameter> table = makeStudyParameters();
  return table;
}

Study readStudy(const std::string& file) {
  return within(file + ": ", [&] {
    const RawScene raw = rawScene(readText(file), file);
    if (raw.list.isSublist("Bodies"))
      throw InputError("is a scene, not a study; to solve it: epafi run " + file);
    return build(file, raw);
  });
}

}  // namespace epafi::drivers
