#include "drivers/scene/SceneReader.hpp"

#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"
#include "drivers/process/Versions.hpp"
#include "drivers/scene/BodiesReader.hpp"
#include "drivers/scene/BodyLoadsReader.hpp"
#include "drivers/scene/ConditionsReader.hpp"
#include "drivers/scene/ContactsReader.hpp"
#include "drivers/scene/GeometryReader.hpp"
#include "drivers/scene/Incompressible.hpp"
#include "drivers/scene/Override.hpp"
#include "drivers/scene/RemovedKeys.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"

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

Scene::Solver readSolver(const ParameterList& list) {
  Scene::Solver solver{contact::parseContactSolver(list), contact::parseCoulomb(list),
                       nullptr};
  if (list.isSublist("NOX") && list.sublist("NOX").numParams() > 0) {
    const auto nox = std::make_shared<ParameterList>(list.sublist("NOX"));
    nox->setName("Solver->NOX");
    solver.nox = nox;
  }
  return solver;
}

/// The scene with what a tolerance alone asks for.
ParameterList withStrategy(ParameterList scene) {
  if (scene.isSublist("Adaptivity") &&
      scene.sublist("Adaptivity").isParameter("Tolerance")) {
    ParameterList& list = scene.sublist("Adaptivity");
    if (!list.isParameter("Strategy"))
      list.set("Strategy", "Graded hp");
    if (!list.isParameter("Maximum Levels"))
      list.set("Maximum Levels", 100);
  }
  return scene;
}

Scene::Adaptivity readAdaptivity(const ParameterList& list) {
  Scene::Adaptivity adaptivity{adaptivity::parseStrategy(list),
                               adaptivity::parseEstimator(list), parseLimits(list)};
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
  OutputOptions output = parseOutput(list);
  for (std::size_t i = 0; i < output.interiorPoints.size(); ++i)
    if (scene.bodyAt(scene.drawn(output.interiorPoints[i])) == scene.bodies.size())
      throw InputError("Output->Interior Points: point ", i, " = (",
                       output.interiorPoints[i].x, ", ", output.interiorPoints[i].y,
                       scene.bodies.size() == 1 ? ") is not inside the body"
                                                : ") is not inside any body");
  return output;
}

/// Reads the lists Tables and Constants, which the others may name.
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

/// The conditions of all bodies at a time: what their lists say then, on what reading the
/// bodies and their contacts has found for good.
std::function<std::vector<contact::Conditions>(double t)> conditionsOf(
    const Scene& scene) {
  return [lists = scene.used, file = scene.file, bodies = scene.bodies,
          symmetry = scene.symmetry, stress = scene.stress,
          names = scene.names()](double t) {
    Names now = names;
    now.t = t;
    std::vector<contact::Conditions> all;
    for (const Body& body : bodies) {
      all.push_back(readConditions(lists->sublist("Bodies").sublist(body.name),
                                   {file, "Bodies->" + body.name}, *body.outline,
                                   symmetry, now));
      all.back().pins = body.conditions.pins;
      const BodyLoadsReader reader(*lists, body.name, {file, ""});
      all.back().inside = reader.inside(*body.outline, body.material, stress, now);
      all.back().heat = reader.heat(*body.outline, now);
      for (const auto& [boundary, contact] : body.conditions.contact)
        if (!contact.name.empty()) {
          now.normal = normalOn(*body.outline, boundary);
          contact::Conditions::Contact condition =
              readContactOfBodies(lists->sublist("Contacts").sublist(contact.name),
                                  {file, "Contacts->" + contact.name}, now);
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
  if (!scene.history)
    used.remove("History");
  const std::vector<contact::Conditions> end = scene.conditionsAt(scene.endOfPath());
  for (std::size_t b = 0; b < end.size(); ++b) {
    for (const auto& [boundary, contact] : end[b].contact)
      if (contact.wear && !scene.history)
        throw InputError("contact '", contact.name.empty() ? boundary : contact.name,
                         "' wears, which takes a path: give History->Times");
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
  scene.expressions = evaluateNumbers(given, file, scene.names());
  scene.used =
      Teuchos::rcp(new ParameterList(bem::complete(parameters(), given, raw.title)));
  ParameterList& used = *scene.used;
  const ParameterList& discretization = used.sublist("Discretization");
  scene.symmetry = parseSymmetry(used.sublist("Geometry"));
  readBodies(used.sublist("Bodies"), discretization, scene);
  readContacts(used.sublist("Contacts"), file, scene);
  scene.multiplier = discretization.get<std::string>("Multiplier");
  scene.stabilization =
      contact::parseStabilization(discretization.sublist("Stabilization"));
  if (contact::multiplierBasis(scene.multiplier).sharesNodes)
    scene.stabilization.form = contact::Stabilization::Form::None;
  pinIncompressible(scene);
  scene.solver = readSolver(used.sublist("Solver"));
  readHistory(used, scene);
  scene.drivesAt(scene.endOfPath());  // what is no number in t shall be said at once
  scene.linear = parseLinear(used.sublist("Solver").sublist("Linear"));
  checkLinear(scene);
  scene.adaptivity = readAdaptivity(used.sublist("Adaptivity"));
  scene.output = readOutput(used.sublist("Output"), scene);
  return scene;
}

/// Every message names the file first.
template <class Read>
auto naming(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.rfind(file + ": ", 0) == 0)
      throw;
    throw InputError(file + ": " + what);
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
    dropRemovedKeys(raw.list);
    return build(file, raw);
  });
}

std::string usedXml(const Scene& scene) {
  ParameterList list(*scene.used);
  putBack(scene.expressions, list);
  const Versions current = versions();
  list.remove("Versions", false);
  list.sublist("Versions")
      .set("Epafi", current.epafi)
      .set("Trilinos", current.trilinos)
      .set("MPI", current.mpi)
      .set("BLAS Core", current.blasCore);
  return toXml(list, scene.title);
}

}  // namespace epafi::drivers
