#include "drivers/run/NextLevel.hpp"

#include "adaptivity/refine/LineOfSymmetry.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/refine/StartValue.hpp"
#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/ContactEstimate.hpp"
#include "drivers/run/LevelMarks.hpp"
#include "drivers/run/MatchedSides.hpp"
#include "drivers/run/Room.hpp"
#include "drivers/run/UnheldMotions.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

namespace epafi::drivers {

namespace {

/// With elements of contacts halved that begin or end at a corner or at an end of contact.
std::vector<bem::Piece> halvedAtEnds(const bem::Mesh& mesh,
                                     const contact::Conditions& conditions) {
  const auto points = adaptivity::findSingularPoints(mesh, conditions);
  adaptivity::Marks marks(mesh.size());
  for (int e = 0; e < mesh.size(); ++e)
    if (contact::contactOn(mesh, e, conditions) != nullptr &&
        (points.at(mesh, e, false) != adaptivity::Singularity::None ||
         points.at(mesh, e, true) != adaptivity::Singularity::None))
      marks[e] = adaptivity::Mark::Bisect;
  return piecesOf(adaptivity::gradedLines(adaptivity::refine(mesh, marks), conditions));
}

}  // namespace

Level firstLevel(const Scene& scene) {
  Level first = firstMeshes(scene);
  first.meshes = matchedAtBonds(scene, std::move(first.meshes));
  constexpr int most = 12;
  Level finer = first;
  const BodySpaces spaces(scene, first);
  for (const double t : scene.history.times)
    checkRoom(spaces, t);
  std::vector<double> left = unbalanced(spaces, scene.history.times);
  for (int k = 0; k < most && !left.empty(); ++k) {
    for (std::size_t b = 0; b < finer.meshes.size(); ++b)
      finer.meshes[b] = halvedAtEnds({scene.bodies[b].outline, finer.meshes[b]},
                                     scene.bodies[b].conditions);
    const std::size_t before = left.size();
    left = unbalanced(BodySpaces(scene, finer), left);
    if (left.size() < before)
      first.meshes = finer.meshes;
  }
  return first;
}

namespace {

/// Does the whole keep Adaptivity->Tolerance, whatever its contacts do?
bool isReachedByWhole(const Scene& scene, const Level& level) {
  const auto& tolerance = scene.adaptivity.limits.tolerance;
  return tolerance && level.relativeEstimate <= *tolerance;
}

bool isReached(const Scene& scene, const Level& level) {
  return isReachedByWhole(scene, level) &&
         worst(level.contacts, *scene.adaptivity.limits.tolerance) == nullptr;
}

/// The part of the estimate that short elements carry, which no level makes smaller.
double shareOfShort(const BodySpaces& spaces, const Level& level) {
  double ofShort = 0;
  double all = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Vector squares = level.indicators[b].elements();
    for (std::size_t e = 0; e < squares.size(); ++e) {
      all += squares[e];
      if (adaptivity::isShort(spaces.space(b).mesh(), static_cast<int>(e)))
        ofShort += squares[e];
    }
  }
  return all > 0 ? std::sqrt(ofShort / all) : 0;
}

/// Under Weights "Paper" squares of different units are added, which tell no error.
bool isNoResult(const Scene& scene, const Level& level) {
  return scene.adaptivity.estimator.weights != "Paper" && level.relativeEstimate > 1;
}

/// The error, and what is reached of Adaptivity->Tolerance.
std::string reached(const Scene& scene, const Level& level) {
  std::ostringstream text;
  text << std::setprecision(3) << "the estimated error is "
       << 100 * level.relativeEstimate << " % of the energy norm"
       << (scene.history ? " in the worst step" : "");
  const auto& tolerance = scene.adaptivity.limits.tolerance;
  if (!tolerance)
    return text.str();
  if (const ContactEstimate* contact = worst(level.contacts, *tolerance)) {
    text << "; at contact '" << contact->name << "' ";
    if (contact->relative > *tolerance)
      text << 100 * contact->relative << " % of that of '"
           << scene.bodies[contact->body].name << "'";
    else if (contact->closed.size() < fewestClosed)
      text << "only " << counted(contact->closed.size(), "element is", "elements are")
           << " closed";
    else
      return bem::message(text.str(), "the largest pressure is uncertain by ",
                          100 * contact->doubt, " %, above the ", 100 * mostDoubt,
                          " % that are allowed");
  }
  text << (isReached(scene, level) ? ", within" : ", above")
       << " Adaptivity->Tolerance = " << *tolerance;
  return text.str();
}

/// Is there a state under the first load?  Not where the first step of a path was solved in parts.
bool hasFirst(const Scene& scene, const Level& level) {
  return !scene.history || level.path.front().t == scene.history.times.front();
}

/// The state from which the next level starts: under the load, or in the first step of a path.
SolvedState carryFirst(const BodySpaces& spaces, const Level& level, const Level& next) {
  const Scene& scene = spaces.scene();
  const SolvedState& first = level.steps.front();
  SolvedState start;
  start.rigid = first.rigid;
  std::vector<bem::Mesh> meshes;
  meshes.reserve(spaces.size());  // what refers to them follows
  std::vector<contact::MultiplierSpace::Body> bodies;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    meshes.emplace_back(scene.bodies[b].outline, next.meshes[b]);
    bodies.push_back({meshes.back(), scene.bodies[b].conditions});
  }
  start.state =
      adaptivity::carry(spaces.multiplier(), first.state,
                        contact::MultiplierSpace(bodies, spaces.multiplier().basis()));
  return start;
}

}  // namespace

std::string missingTo(const Scene& scene, const Level& level) {
  if (isNoResult(scene, level))
    return "; this is no result: " + reached(scene, level);
  return scene.adaptivity.limits.tolerance && !isReached(scene, level)
             ? "; " + reached(scene, level)
             : "";
}

Outcome ended(const Scene& scene, const Level& level, const std::string& reason) {
  return {isNoResult(scene, level) && scene.adaptivity.limits.tolerance
              ? contact::Status::NotConverged
              : contact::Status::Converged,
          reason + missingTo(scene, level)};
}

std::variant<Level, Outcome> nextLevel(const Scene& scene, const Level& level,
                                       const bem::Processes& processes) {
  if (level.status != contact::Status::Converged)
    return Outcome{level.status, bem::message("level ", level.number,
                                              " is not converged: ", level.reason)};
  if (isReached(scene, level))
    return ended(scene, level, reached(scene, level));
  if (level.estimate() < scene.adaptivity.limits.estimate)
    return ended(scene, level, "the estimate is below the target");
  if (level.number + 1 >= scene.adaptivity.limits.levels)
    return ended(scene, level, "all levels that the scene allows are computed");

  const BodySpaces spaces(scene, level);
  const double untold = shareOfShort(spaces, level) * level.relativeEstimate;
  if (const auto& tolerance = scene.adaptivity.limits.tolerance;
      tolerance && untold > *tolerance)
    return ended(
        scene, level,
        bem::message("elements as short as the digits of coordinates allow carry an "
                     "estimated error of ",
                     100 * untold, " %"));
  const std::vector<adaptivity::Marks> marks =
      marksOf(spaces, level, isReachedByWhole(scene, level), processes);
  if (std::none_of(marks.begin(), marks.end(), adaptivity::anyMarked))
    return ended(
        scene, level,
        "there is nothing to refine: what carries the estimate are elements as short as "
        "the digits of coordinates allow, or of the highest degree");

  Level next{level.number + 1};
  for (std::size_t b = 0; b < spaces.size(); ++b)
    next.meshes.push_back(piecesOf(
        adaptivity::gradedLines(adaptivity::refine(spaces.space(b).mesh(), marks[b]),
                                scene.bodies[b].conditions)));
  if (strategyOf(scene).start == adaptivity::Start::Carried && hasFirst(scene, level))
    next.steps = {carryFirst(spaces, level, next)};
  return next;
}

std::variant<Level, Outcome> levelAfterRestart(const Scene& scene, const Level& level,
                                               const bem::Processes& processes) {
  Level again = level;
  if (level.isSolved()) {
    if (scene.adaptivity.limits.tolerance)
      again.contacts = contactEstimates(BodySpaces(scene, level), level, processes);
    return nextLevel(scene, again, processes);
  }
  if (scene.history)  // whose last state is not that of the first step
    again.steps.clear();
  return again;
}

}  // namespace epafi::drivers
