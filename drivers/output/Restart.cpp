#include "drivers/output/Restart.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/OutputFolder.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>

namespace epafi::drivers {

using bem::InputError;
using Teuchos::ParameterList;

namespace {

std::vector<std::string> keysOf(const ParameterList& a, const ParameterList& b) {
  std::vector<std::string> keys;
  for (const ParameterList* list : {&a, &b})
    for (const auto& item : *list)
      keys.push_back(item.first);
  return keys;
}

}  // namespace

std::string difference(const ParameterList& a, const ParameterList& b,
                       const std::string& path, const std::vector<std::string>& keys,
                       const std::set<std::string>& without) {
  for (const std::string& key : keys) {
    if (without.count(key) != 0)
      continue;
    const auto* inA = a.getEntryPtr(key);
    const auto* inB = b.getEntryPtr(key);
    const bool inBoth = inA != nullptr && inB != nullptr;
    std::string place = bem::join(path, key);
    if (inBoth && inA->isList() && inB->isList()) {
      const ParameterList& ofA = a.sublist(key);
      const ParameterList& ofB = b.sublist(key);
      place = difference(ofA, ofB, place, keysOf(ofA, ofB), without);
    } else if (inA == inB || (inBoth && inA->getAny() == inB->getAny())) {
      place.clear();
    }
    if (!place.empty())
      return place;
  }
  return "";
}

namespace {

void checkScene(const Checkpoint& checkpoint, const Scene& scene) {
  const Scene earlier = sceneOf(checkpoint.used, "used.xml", {});
  const ParameterList& then = *earlier.used;
  const ParameterList& now = *scene.used;
  std::string different =
      difference(then, now, "",
                 {"Bodies", "Geometry", "Body Loads", "Contacts", "Constants", "Tables",
                  "History", "Discretization"});
  if (different.empty())
    different = difference(then.sublist("Adaptivity"), now.sublist("Adaptivity"),
                           "Adaptivity", {"Weights", "Residual Factor"});
  if (!different.empty())
    throw InputError(
        "was written by a run of another scene: ", different,
        " differs; Bodies, Geometry, Body Loads, Contacts, Constants, Tables, History, "
        "Discretization, Adaptivity->Weights and Adaptivity->Residual Factor must be as "
        "they were");
}

void checkColumns(const Table& table, const Table& wanted) {
  if (!table.hasColumnsOf(wanted))
    throw InputError(
        "has tables with other columns than this version of Epafi; solve the "
        "scene again");
}

/// Checks that sizes, indices and columns fit the meshes.
void checkMeaning(const Checkpoint& checkpoint, const Scene& scene) {
  checkLevel(checkpoint.level, scene);
  const Level& level = checkpoint.level;
  if (scene.history && level.isSolved() &&
      checkpoint.steps.rowsWith("level", level.number).size() != level.steps.size())
    throw InputError("has not one row of steps.csv per step");
  if (checkpoint.steps.rows() > 0)
    checkColumns(checkpoint.steps, stepsTable(BodySpaces(scene, checkpoint.level)));
}

/// Takes the rows of a level that is solved again from a table.
void leaveSolved(const Level& level, Table& table) {
  if (level.isSolved() || !table.hasColumns())
    return;
  if (const auto rows = table.rowsWith("level", level.number); !rows.empty())
    table.keep(rows.front());
}

void checkHistory(const Table& history, const Level& level, const Scene& scene) {
  checkColumns(history, historyTable(scene));
  if (history.rows() != bem::at(level.number + (level.complete ? 1 : 0)))
    throw InputError("has not one row of history.csv per level");
}

bem::Index freeMotions(const std::vector<RigidBody>& bodies) {
  bem::Index count = 0;
  for (const RigidBody& body : bodies)
    count += std::count_if(body.components.begin(), body.components.end(),
                           [](const auto& component) { return component.free; });
  return count;
}

}  // namespace

void checkLevel(const Level& level, const Scene& scene) {
  if (level.meshes.size() != scene.bodies.size())
    throw InputError("has not as many bodies as the scene");
  for (std::size_t b = 0; b < level.meshes.size(); ++b) {
    const auto edges = static_cast<int>(scene.bodies[b].outline->edges().size());
    for (const bem::Piece& piece : level.meshes[b])
      if (piece.edge < 0 || piece.edge >= edges)
        throw InputError("has an element on edge ", piece.edge, "; the outline has ",
                         edges, " edges");
  }
  const SolvedState& last = level.last();
  if (last.rigid.size() != scene.rigid.size())
    throw InputError("has not the motions of the scene's rigid bodies");
  const BodySpaces spaces(scene, level);
  const auto size = [](const auto& numbers) {
    return static_cast<bem::Index>(numbers.size());
  };
  const contact::MultiplierSpace& multiplier = spaces.multiplier();
  const bem::Index motions = size(last.state.rigid);
  for (const SolvedState& point : level.path)
    if (size(point.state.multiplier) != multiplier.size() ||
        size(point.state.rigid) != motions)
      throw InputError("has a path that does not fit its own mesh");
  if (size(last.state.multiplier) != multiplier.size() ||
      size(last.states) != multiplier.size() ||
      std::count_if(last.states.begin(), last.states.end(), contact::isOfPressure) !=
          multiplier.normals() ||
      motions < freeMotions(scene.rigid))
    throw InputError("does not fit its own mesh");
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    if (level.number < 0 ||
        size(last.displacement[b]) != spaces.space(b).displacements() ||
        size(last.density[b]) != spaces.space(b).densities() ||
        size(level.indicators[b].squares) != spaces.space(b).mesh().size())
      throw InputError("does not fit its own mesh");
  }
  if (scene.history && level.isSolved() && level.path.empty())
    throw InputError("has no path");
}

namespace {

/// Level::doubts of the last level, from the tables.
bem::Vector doubtsIn(const Checkpoint& checkpoint, const Scene& scene) {
  bem::Vector doubts;
  const Table& table = scene.history ? checkpoint.steps : checkpoint.history;
  for (const auto& [name, ignored] :
       BodySpaces(scene, checkpoint.level).stepRow().contacts) {
    double largest = 0;
    double doubt = 0;
    for (const std::size_t row : table.rowsWith("level", checkpoint.level.number)) {
      const double value = table.number(row, name + ".pressure_max");
      if (value > largest) {
        largest = value;
        doubt = table.number(row, name + ".pressure_unbounded") > 0
                    ? 0
                    : table.number(row, name + ".pressure_max_error") / value;
      }
    }
    doubts.push_back(doubt);
  }
  return doubts;
}

/// Level::energies of the last level, from the tables.
bem::Vector energiesIn(const Checkpoint& checkpoint, const Scene& scene) {
  bem::Vector energies(scene.bodies.size(), 0.0);
  const Table& table = scene.tellsBodies() ? checkpoint.bodies
                       : scene.history     ? checkpoint.steps
                                           : checkpoint.history;
  for (const std::size_t row : table.rowsWith("level", checkpoint.level.number))
    for (std::size_t b = 0; b < energies.size(); ++b)
      if (!scene.tellsBodies() || table.word(row, "body") == scene.bodies[b].name) {
        const bool isHalf =
            scene.tellsBodies() && !scene.symmetry.cuts(*scene.bodies[b].outline);
        energies[b] = std::max(energies[b], (isHalf ? scene.symmetry.copies() : 1) *
                                                table.number(row, "energy_strain"));
      }
  return energies;
}

}  // namespace

Checkpoint readRestart(const std::string& folder, const Scene& scene) {
  return within("--restart: ", [&] {
    const std::string path = ownFile(folder, "solution.hdf");
    Checkpoint checkpoint = readSolution(path);
    within("'" + path + "' ", [&] {
      checkScene(checkpoint, scene);
      checkMeaning(checkpoint, scene);
      Level& level = checkpoint.level;
      checkHistory(checkpoint.history, level, scene);
      if (checkpoint.bodies.hasColumns())
        checkColumns(checkpoint.bodies, bodiesTable());
      for (Table* table : {&checkpoint.history, &checkpoint.steps, &checkpoint.bodies})
        leaveSolved(level, *table);
      if (level.isSolved()) {
        level.relativeEstimate =
            checkpoint.history.number(checkpoint.history.rows() - 1, "estimate_relative");
        level.energies = energiesIn(checkpoint, scene);
        level.doubts = doubtsIn(checkpoint, scene);
      }
    });
    return checkpoint;
  });
}

}  // namespace epafi::drivers
