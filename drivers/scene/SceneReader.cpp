#include "drivers/scene/SceneReader.hpp"

#include "bem/base/Error.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/Images.hpp"
#include "drivers/scene/Incompressible.hpp"
#include "drivers/scene/Readers.hpp"
#include "drivers/scene/Revolution.hpp"
#include "drivers/scene/SceneFile.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_TwoDArray.hpp>

#include <algorithm>
#include <utility>

namespace epafi::drivers {

namespace {

using bem::InputError;
using Teuchos::ParameterList;

void checkAnyBody(const ParameterList& list) {
  if (list.isSublist("Bodies") &&
      list.sublist("Bodies").begin() == list.sublist("Bodies").end())
    throw InputError("Bodies: no body is given; at least one is needed");
}

/// Refuses the used.xml of versions that had other keys.
void checkVersion(const ParameterList& list) {
  if (!list.isSublist("Versions") ||
      !list.sublist("Versions").isType<std::string>("Epafi"))
    return;
  const auto& by = list.sublist("Versions").get<std::string>("Epafi");
  for (const char* former : {"0.0.", "0.1."})
    if (by.rfind(former, 0) == 0)
      throw InputError("was written by Epafi ", by, "; Epafi ", versions().epafi,
                       " reads what 0.2 and later ones write; take the scene itself");
}

void checkLinear(const Scene& scene) {
  const LinearMethod& method = linearMethods().at(scene.solver.linear.method);
  const std::string reason = contact::whyNotCompressed(scene.stabilization);
  if (method.operators == LinearMethod::Operators::Compressed && !reason.empty())
    throw InputError("Solver->Linear->Method = ", method.name, ": ", reason,
                     "; Dense, Belos and Automatic are possible");
  for (const Body& body : scene.bodies)
    if (!method.factors && !body.conditions.pins.empty())
      throw InputError("Solver->Linear->Method = ", method.name,
                       ": cannot solve for body '", body.name,
                       "', whose Poisson's Ratio is 1/2 and which has a closed line "
                       "without contact; Automatic, Dense and Compressed can");
}

/// Does a scene say how long or how many its first elements are?
bool statesMesh(const ParameterList& scene) {
  if (scene.isSublist("Discretization") && isSized(scene.sublist("Discretization")))
    return true;
  if (!scene.isSublist("Bodies"))
    return false;
  const ParameterList& bodies = scene.sublist("Bodies");
  return std::any_of(bodies.begin(), bodies.end(), [&](const auto& body) {
    return bodies.isSublist(body.first) && bodies.sublist(body.first).isSublist("Mesh") &&
           isSized(bodies.sublist(body.first).sublist("Mesh"));
  });
}

/// The scene with the strategy and the number of levels that a tolerance alone implies, and with the
/// tolerance that is implied where neither mesh nor strategy is stated.
ParameterList withStrategy(ParameterList scene) {
  constexpr double usual = 0.01;
  const bool adapts = scene.isSublist("Adaptivity");
  if (scene.isParameter("Adaptivity") && !adapts)  // refused later
    return scene;
  const auto says = [&](const char* key) {
    return adapts && scene.sublist("Adaptivity").isParameter(key);
  };
  const bool tolerance = says("Tolerance");
  if (!tolerance && (says("Strategy") || statesMesh(scene)))
    return scene;
  ParameterList& list = scene.sublist("Adaptivity");
  if (!list.isParameter("Strategy"))
    list.set("Strategy", "Graded hp");
  if (!list.isParameter("Maximum Levels"))
    list.set("Maximum Levels", 100);
  const bool isPaper = list.isParameter("Weights") &&
                       list.isType<std::string>("Weights") &&
                       list.get<std::string>("Weights") == "Paper";
  if (!tolerance && !isPaper && !list.isParameter("Target Estimate"))
    list.set("Tolerance", usual);
  return scene;
}

AdaptivityOptions readAdaptivity(const ParameterList& list) {
  auto adaptivity = bem::parsed<AdaptivityOptions>(list);
  if (adaptivity.limits.tolerance && adaptivity.estimator.weights != "Energy")
    throw InputError(
        "Adaptivity->Tolerance: is a part of the energy norm, and so needs Weights = "
        "Energy");
  if (adaptivity::strategies().at(adaptivity.strategy.name).levels ==
      adaptivity::Levels::One)
    adaptivity.limits.levels = 1;
  return adaptivity;
}

OutputOptions readOutput(const ParameterList& list, const Scene& scene) {
  auto output = bem::parsed<OutputOptions>(list);
  for (std::size_t i = 0; i < output.interiorPoints.size(); ++i)
    if (scene.bodyAt(scene.drawn(output.interiorPoints[i])) == scene.bodies.size())
      throw InputError("Output->Interior Points: point ", i, " = (",
                       output.interiorPoints[i].x, ", ", output.interiorPoints[i].y,
                       scene.bodies.size() == 1 ? ") is not inside the body"
                                                : ") is not inside any body");
  return output;
}

/// Reads the lists Tables and Constants, whose names other lists may use.
void readNames(ParameterList& given, Scene& scene) {
  ParameterList names;
  for (const char* list : {"Tables", "Constants"})
    if (given.isParameter(list))
      names.setEntry(list, given.getEntry(list));
  bem::SchemaRows rows;
  for (const Parameter& row : parameters())
    if (row.path.rfind("Tables", 0) == 0 || row.path.rfind("Constants", 0) == 0)
      rows.push_back(row);
  names = bem::complete(rows, names, "");
  scene.tables = readTables(names.sublist("Tables"), {scene.file, "Tables"});
  scene.constants =
      readConstants(names.sublist("Constants"), {scene.file, "Constants"}, scene.tables);
  for (const auto& item : names)
    given.setEntry(item.first, item.second);
}

/// The conditions of all bodies at a time: the lists at that time, with the pins and the
/// parts of contacts that were found when the bodies and contacts were read.
std::function<std::vector<contact::Conditions>(double t)> conditionsOf(
    const Scene& scene) {
  return [root = scene.root(), bodies = scene.bodies, symmetry = scene.symmetry,
          stress = scene.stress](double t) {
    const Part now = root.then(t);
    std::vector<contact::Conditions> all;
    for (const Body& body : bodies) {
      all.push_back(
          readConditions(now.sub("Bodies").sub(body.name), *body.outline, symmetry));
      all.back().pins = body.conditions.pins;
      all.back().facing = body.conditions.facing;
      all.back().images = body.conditions.images;
      const BodyLoadsReader reader(now, body.name);
      all.back().inside = reader.inside(*body.outline, body.material, stress);
      all.back().heat = reader.heat(*body.outline);
      for (const auto& [boundary, contact] : body.conditions.contact)
        if (!contact.name.empty()) {
          Part part = now.sub("Contacts").sub(contact.name);
          part.names.onBoundary = true;
          contact::Conditions::Contact condition = readContactOfBodies(part);
          condition.name = contact.name;
          condition.parts = contact.parts;
          all.back().contact[boundary] = std::move(condition);
        }
    }
    return all;
  };
}

void readHistory(ParameterList& used, Scene& scene) {
  scene.history = parseHistory(used.sublist("History"));
  scene.conditionsAt = conditionsOf(scene);
  const std::vector<std::set<int>> images = imageCorners(scene);
  for (std::size_t b = 0; b < images.size(); ++b)
    scene.bodies[b].conditions.images = images[b];
  scene.conditionsAt = conditionsOf(scene);
  if (!scene.history)
    used.remove("History");
  const std::vector<contact::Conditions> end = scene.conditionsAt(scene.endOfPath());
  for (std::size_t b = 0; b < end.size(); ++b) {
    for (const auto& [boundary, contact] : end[b].contact)
      if (contact.wear && !scene.history)
        throw InputError(contact.path, "->Wear: wear takes a path: give History->Times");
    scene.bodies[b].conditions = end[b];
  }
}

Scene build(const std::string& file, const RawScene& raw) {
  checkAnyBody(raw.list);
  Scene scene;
  scene.title = raw.title;
  scene.file = file;
  ParameterList given = withStrategy(raw.list);
  readNames(given, scene);
  scene.given = given;
  const auto constant = [&](const std::string& text, const std::string& path) {
    return makeExpression(text, {file, path}, scene.names(), Form::OfConstants)({});
  };
  scene.used = std::make_shared<ParameterList>(
      bem::complete(parameters(), given, raw.title, constant));
  ParameterList& used = *scene.used;
  const ParameterList& discretization = used.sublist("Discretization");
  scene.symmetry = parseSymmetry(used.sublist("Geometry"));
  scene.isAxisymmetric = parseRevolution(used.sublist("Geometry"));
  readBodies(scene);
  readContacts(scene);
  scene.multiplier = discretization.get<std::string>("Multiplier");
  scene.stabilization =
      bem::parsed<contact::Stabilization>(discretization.sublist("Stabilization"));
  if (contact::multiplierBasis(scene.multiplier).sharesNodes)
    scene.stabilization.form = contact::Stabilization::Form::None;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    pinIncompressible(b, scene);
  scene.solver = parseSolver(used.sublist("Solver"));
  readHistory(used, scene);
  scene.drivesAt(scene.endOfPath());  // evaluate once, so that errors are reported now
  checkLinear(scene);
  scene.adaptivity = readAdaptivity(used.sublist("Adaptivity"));
  scene.output = readOutput(used.sublist("Output"), scene);
  if (scene.isAxisymmetric)
    checkRevolution(scene);
  return scene;
}

/// Replaces numbers in `used` by the expressions from which they were computed.
void putBackTexts(const ParameterList& given, ParameterList& used) {
  for (const auto& item : given) {
    if (!used.isParameter(item.first))
      continue;
    const auto text = bem::writtenIn(item.second);
    if (item.second.isList() && used.isSublist(item.first))
      putBackTexts(given.sublist(item.first), used.sublist(item.first));
    else if (text && text->isText() &&
             !bem::writtenIn(used.getEntry(item.first))->isText())
      used.setEntry(item.first, item.second);
  }
}

/// Replaces expressions in `list`, a copy of the part's own, by their values.
void putNumbers(const Part& part, ParameterList& list) {
  for (const auto& item : *part.list) {
    const Kind kind = bem::declared(parameters(), part.path(item.first)).kind;
    if (kind == Kind::List)
      putNumbers(part.sub(item.first), list.sublist(item.first));
    if (kind != Kind::Expression)
      continue;
    const auto value = constantIn(part.list->get<std::string>(item.first),
                                  part.at(item.first), part.names);
    if (value)
      list.set(item.first, *value);
  }
}

}  // namespace

Scene readScene(const std::string& file, const std::vector<std::string>& overrides) {
  return sceneOf(naming(file, [&] { return readText(file); }), file, overrides);
}

Scene sceneOf(const std::string& text, const std::string& file,
              const std::vector<std::string>& overrides) {
  return naming(file, [&] {
    RawScene raw = rawScene(text, file);
    if (raw.list.isSublist("Scenes"))
      throw InputError("is a study, not a scene; to run it: epafi study " + file);
    for (const std::string& assignment : overrides)
      applyOverride(raw.list, assignment);
    checkVersion(raw.list);
    return build(file, raw);
  });
}

ParameterList usedList(const Scene& scene) {
  ParameterList list(*scene.used);
  putBackTexts(scene.given, list);
  const Versions current = versions();
  list.remove("Versions", false);
  list.sublist("Versions")
      .set("Epafi", current.epafi)
      .set("Trilinos", current.trilinos)
      .set("MPI", current.mpi)
      .set("BLAS Core", current.blasCore);
  return list;
}

std::string usedXml(const Scene& scene) { return toXml(usedList(scene), scene.title); }

ParameterList numbersOf(const Scene& scene) {
  Part root = scene.root().then(scene.endOfPath());
  root.names.onBoundary = true;
  root.names.ofPressure = true;
  ParameterList list(*scene.used);
  putNumbers(root, list);
  return list;
}

}  // namespace epafi::drivers
