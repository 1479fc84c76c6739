#include "drivers/output/Restart.hpp"

#include "bem/base/Error.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>

namespace epafi::drivers {

using bem::InputError;
using Teuchos::ParameterList;

std::string differenceIn(const ParameterList& a, const ParameterList& b,
                         const std::string& path, const std::string& name,
                         const std::set<std::string>& without) {
  if (without.count(name) != 0)
    return "";
  const auto* inA = a.getEntryPtr(name);
  const auto* inB = b.getEntryPtr(name);
  const std::string here = bem::join(path, name);
  if (inA == nullptr || inB == nullptr)
    return inA == inB ? "" : here;
  if (!inA->isList() || !inB->isList())
    return inA->getAny() == inB->getAny() ? "" : here;
  for (const ParameterList* list : {&a.sublist(name), &b.sublist(name)})
    for (const auto& item : *list) {
      std::string found =
          differenceIn(a.sublist(name), b.sublist(name), here, item.first, without);
      if (!found.empty())
        return found;
    }
  return "";
}

namespace {

/// The scene for which a checkpoint was written.
ParameterList sceneOf(const Checkpoint& checkpoint) {
  return *drivers::sceneOf(checkpoint.used, "used.xml", {}).used;
}

void checkScene(const Checkpoint& checkpoint, const Scene& scene) {
  const ParameterList then = sceneOf(checkpoint);
  const ParameterList& now = *scene.used;
  std::string different;
  for (const char* section : {"Bodies", "Geometry", "Body Loads", "Contacts", "Constants",
                              "Tables", "History", "Discretization"})
    if (different.empty())
      different = differenceIn(then, now, "", section, {});
  for (const char* key : {"Weights", "Residual Factor"})
    if (different.empty())
      different = differenceIn(then.sublist("Adaptivity"), now.sublist("Adaptivity"),
                               "Adaptivity", key, {});
  if (!different.empty())
    throw InputError(
        "was written by a run of another scene: ", different,
        " differs; Bodies, Geometry, Body Loads, Contacts, Constants, Tables, History, "
        "Discretization, "
        "Adaptivity->Weights and Adaptivity->Residual Factor must be as they were");
}

void checkHead(const std::string& table, const std::string& head) {
  if (table.rfind(head, 0) != 0)
    throw InputError(
        "has tables with other columns than this version of Epafi; solve the "
        "scene again");
}

/// Checks that sizes, indices and columns fit the meshes.
void checkMeaning(const Checkpoint& checkpoint, const Scene& scene) {
  checkLevel(checkpoint.level, scene);
  if (!checkpoint.steps.empty())
    checkHead(checkpoint.steps,
              headOf(cellsOf(BodySpaces(scene, checkpoint.level).stepRow())));
}

/// history.csv without a last level that has not converged: it is solved again.
std::string historyBehind(const Checkpoint& checkpoint) {
  const std::string& text = checkpoint.history;
  checkHead(text, headOf(cellsOf(LevelRow())));
  const int rows = checkpoint.level.number + (checkpoint.level.complete ? 1 : 0);
  if (std::count(text.begin(), text.end(), '\n') != rows + 1)
    throw InputError("has not one row of history.csv per level");
  if (checkpoint.level.status == contact::Status::Converged || !checkpoint.level.complete)
    return text;
  return text.substr(0, text.rfind('\n', text.size() - 2) + 1);
}

/// The same for a table whose rows begin with the level; drops all rows of a level that
/// is solved again.
std::string rowsBehind(const std::string& text, const Checkpoint& checkpoint) {
  if (checkpoint.level.status == contact::Status::Converged && checkpoint.level.complete)
    return text;
  const auto row = text.find("\n" + std::to_string(checkpoint.level.number) + ",");
  return row == std::string::npos ? text : text.substr(0, row + 1);
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
  const StepFields& last = level.last();
  if (last.rigid.size() != scene.rigid.size())
    throw InputError("has not the motions of the scene's rigid bodies");
  const BodySpaces spaces(scene, level);
  const auto size = [](const auto& numbers) {
    return static_cast<bem::Index>(numbers.size());
  };
  bem::Index multipliers = 0;
  bem::Index motions = freeMotions(scene.rigid);
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const contact::MultiplierSpace& multiplier = spaces.multiplier(b);
    multipliers += multiplier.size();
    motions += size(last.own[b].rigid);
    if (level.number < 0 ||
        size(last.displacement[b]) != spaces.space(b).displacements() ||
        size(last.density[b]) != spaces.space(b).densities() ||
        size(last.own[b].multiplier) != multiplier.size() ||
        size(last.states[b].normal) != multiplier.normals() ||
        size(last.states[b].tangential) != multiplier.size() - multiplier.normals() ||
        size(level.indicators[b].squares) != spaces.space(b).mesh().size())
      throw InputError("does not fit its own mesh");
  }
  for (const PathPoint& point : level.path)
    if (size(point.state.multiplier) != multipliers || size(point.state.rigid) != motions)
      throw InputError("has a path that does not fit its own mesh");
  if (scene.history && level.complete && level.path.empty() &&
      level.status == contact::Status::Converged)
    throw InputError("has no path");
}

Checkpoint readRestart(const std::string& folder, const Scene& scene) {
  const std::string path = folder + "/solution.hdf";
  return within("--restart: ", [&] {
    Checkpoint checkpoint = readSolution(path);
    within("'" + path + "' ", [&] {
      checkScene(checkpoint, scene);
      checkMeaning(checkpoint, scene);
      checkpoint.history = historyBehind(checkpoint);
      if (checkpoint.level.status == contact::Status::Converged &&
          checkpoint.level.complete)
        checkpoint.level.relativeEstimate =
            valueOf(rowsOf(checkpoint.history).back(), "estimate_relative");
      checkpoint.steps = rowsBehind(checkpoint.steps, checkpoint);
      checkpoint.bodies = rowsBehind(checkpoint.bodies, checkpoint);
      if (!checkpoint.bodies.empty())
        checkHead(checkpoint.bodies, bodiesHead());
    });
    return checkpoint;
  });
}

}  // namespace epafi::drivers
