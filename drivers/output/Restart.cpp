#include "drivers/output/Restart.hpp"

#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "drivers/output/History.hpp"
#include "drivers/scene/SceneFile.hpp"
#include "drivers/scene/Schema.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

using bem::InputError;
using bem::message;
using Teuchos::ParameterList;

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "->" + name;
}

/// The path of the first key that two lists do not agree on; empty if there is none.
std::string difference(const ParameterList& a, const ParameterList& b,
                       const std::string& path);

std::string differenceIn(const ParameterList& a, const ParameterList& b,
                         const std::string& path, const std::string& name) {
  const auto* inA = a.getEntryPtr(name);
  const auto* inB = b.getEntryPtr(name);
  const std::string here = join(path, name);
  if (inA == nullptr || inB == nullptr)
    return inA == inB ? "" : here;
  if (inA->isList() && inB->isList())
    return difference(a.sublist(name), b.sublist(name), here);
  return inA->getAny() == inB->getAny() ? "" : here;
}

std::string difference(const ParameterList& a, const ParameterList& b,
                       const std::string& path) {
  for (const ParameterList* list : {&a, &b})
    for (const auto& item : *list) {
      std::string found = differenceIn(a, b, path, item.first);
      if (!found.empty())
        return found;
    }
  return "";
}

/// Do two outlines agree?  Equal texts may name a file that has changed.
bool agree(const std::vector<EdgeEnds>& a, const std::vector<EdgeEnds>& b,
           double diameter) {
  const auto near = [&](double x, double y) {
    return std::abs(x - y) <= 1e-14 * diameter;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const EdgeEnds& x, const EdgeEnds& y) {
                      return std::equal(x.begin(), x.end(), y.begin(), near);
                    });
}

/// The scene that a file was written by.
ParameterList sceneOf(const Checkpoint& checkpoint) {
  const RawScene scene = readSceneText(checkpoint.used);
  return complete(scene.list, scene.title);
}

void checkScene(const Checkpoint& checkpoint, const Scene& scene) {
  const ParameterList then = sceneOf(checkpoint);
  const ParameterList& now = *scene.used;
  std::string different;
  for (const char* section : {"Bodies", "Discretization"})
    if (different.empty())
      different = differenceIn(then, now, "", section);
  for (const char* key : {"Weights", "Residual Factor"})
    if (different.empty())
      different = differenceIn(then.sublist("Adaptivity"), now.sublist("Adaptivity"),
                               "Adaptivity", key);
  if (!different.empty())
    throw InputError(message("was written by a run of another scene: ", different,
                             " differs; Bodies, Discretization, Adaptivity->Weights and "
                             "Adaptivity->Residual Factor must be as they were"));
}

void checkOutline(const Checkpoint& checkpoint, const bem::Outline& outline) {
  if (!agree(checkpoint.outline, edgeEnds(outline), outline.diameter()))
    throw InputError("was written by a run on another outline");
}

/// The numbers must be those of the mesh; a checksum does not know what they mean.
void checkSizes(const Level& level, const Scene& scene) {
  const auto edges = static_cast<int>(scene.outline->edges().size());
  for (const bem::Piece& piece : level.pieces)
    if (piece.edge < 0 || piece.edge >= edges)
      throw InputError(message("has an element on edge ", piece.edge,
                               "; the outline has ", edges, " edges"));
  const bem::Space space = contact::makeSpace({scene.outline, level.pieces},
                                              scene.conditions, scene.stabilization);
  const contact::MultiplierSpace multiplier(
      space.mesh(), contact::multiplierBasis(scene.multiplier), scene.conditions);
  const auto size = [](const auto& numbers) {
    return static_cast<bem::Index>(numbers.size());
  };
  if (level.number < 0 || size(level.displacement) != space.displacements() ||
      size(level.density) != space.densities() ||
      size(level.state.multiplier) != multiplier.size() ||
      size(level.states.normal) != multiplier.normals() ||
      size(level.states.tangential) != multiplier.size() - multiplier.normals() ||
      size(level.indicators.squares) != space.mesh().size())
    throw InputError("does not fit its own mesh");
}

/// Rows of the levels that the run goes on behind.
std::string historyBehind(const Checkpoint& checkpoint) {
  const std::string& text = checkpoint.history;
  if (text.rfind(historyHead(), 0) != 0)
    throw InputError(
        "was written by a version of Epafi whose history.csv has other "
        "columns");
  if (std::count(text.begin(), text.end(), '\n') != checkpoint.level.number + 2)
    throw InputError("has not one row of history.csv per level");
  if (checkpoint.level.status == contact::Status::Converged)
    return text;
  return text.substr(0, text.rfind('\n', text.size() - 2) + 1);
}

}  // namespace

Checkpoint readRestart(const std::string& folder, const Scene& scene) {
  const std::string path = folder + "/solution.hdf";
  try {
    Checkpoint checkpoint = readSolution(path);
    try {
      checkScene(checkpoint, scene);
      checkOutline(checkpoint, *scene.outline);
      checkSizes(checkpoint.level, scene);
      checkpoint.history = historyBehind(checkpoint);
    } catch (const InputError& error) {
      throw InputError(message("'", path, "' ", error.what()));
    }
    return checkpoint;
  } catch (const InputError& error) {
    throw InputError(message("--restart: ", error.what()));
  }
}

std::optional<Checkpoint> readSolutionOf(const Scene& scene, const std::string& path) {
  try {
    Checkpoint checkpoint = readSolution(path);
    ParameterList then = sceneOf(checkpoint);
    ParameterList now = *scene.used;
    for (ParameterList* list : {&then, &now})
      for (const char* section : {"Output", "Versions"})
        list->remove(section, false);
    if (!difference(then, now, "").empty())
      return std::nullopt;
    checkOutline(checkpoint, *scene.outline);
    checkSizes(checkpoint.level, scene);
    checkpoint.history = historyBehind(checkpoint);
    return checkpoint;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace epafi::drivers
