#include "drivers/run/NextLevel.hpp"

#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/mark/Doerfler.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/refine/StartValue.hpp"
#include "bem/base/Error.hpp"
#include "contact/opposite/Numbering.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/FacingMarks.hpp"
#include "drivers/run/UnheldMotions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

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
  return piecesOf(adaptivity::refine(mesh, marks));
}

}  // namespace

Level firstLevel(const Scene& scene) {
  Level first = firstMeshes(scene);
  constexpr int most = 12;
  Level finer = first;
  const std::vector<double> times =
      scene.history ? scene.history.times : std::vector<double>{1};
  const BodySpaces spaces(scene, first);
  for (const double t : times)
    checkRoom(spaces, t);
  std::vector<double> left = unbalanced(spaces, times);
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

adaptivity::GradingOptions gradingOf(const Scene& scene) {
  adaptivity::GradingOptions grading = scene.adaptivity.strategy.grading;
  grading.largestDegree = contact::multiplierBasis(scene.multiplier).largestDegree;
  return grading;
}

const adaptivity::Strategy& strategyOf(const Scene& scene) {
  return adaptivity::strategies().at(scene.adaptivity.strategy.name);
}

std::vector<SingularMesh> singularMeshes(const BodySpaces& spaces,
                                         const std::vector<StepFields>& steps) {
  const Scene& scene = spaces.scene();
  std::vector<SingularMesh> meshes;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    std::vector<contact::ContactState> states;
    states.reserve(steps.size());
    for (const StepFields& step : steps)
      states.push_back(step.states[b]);
    const bem::Mesh& mesh = spaces.space(b).mesh();
    meshes.push_back(
        {mesh, adaptivity::singularPoints(strategyOf(scene), gradingOf(scene), mesh,
                                          scene.bodies[b].conditions,
                                          spaces.multiplier(b), states)});
  }
  shareSingularPoints(scene, meshes);
  return meshes;
}

/// Of each element of a body: does it look analytic in every step?
std::vector<bool> analyticIn(const std::vector<StepFields>& steps, std::size_t b,
                             const BodySpaces& spaces) {
  const Scene& scene = spaces.scene();
  const bem::Space& space = spaces.space(b);
  std::vector<bool> always(space.mesh().size(), true);
  for (const StepFields& step : steps) {
    const std::vector<bool> now = adaptivity::looksAnalytic(
        space, scene.bodies[b].conditions, step.displacement[b], step.density[b],
        scene.adaptivity.strategy.analyticityThreshold);
    std::transform(now.begin(), now.end(), always.begin(), always.begin(),
                   std::logical_and<>());
  }
  return always;
}

/// The steps whose tractions are not rounding beside the largest ones.  In others, such as one in
/// which all loads are gone, the states of contact are rounding, too.
std::vector<StepFields> loaded(std::vector<StepFields> steps) {
  constexpr double rounding = 1e-9;
  const auto largestOf = [](const StepFields& step) {
    double largest = 0;
    for (const bem::Vector& density : step.density)
      for (const double value : density)
        largest = std::max(largest, std::abs(value));
    return largest;
  };
  double largest = 0;
  for (const StepFields& step : steps)
    largest = std::max(largest, largestOf(step));
  steps.erase(std::remove_if(steps.begin(), steps.end(),
                             [&](const StepFields& step) {
                               return largestOf(step) < rounding * largest;
                             }),
              steps.end());
  return steps;
}

/// The elements that carry most of the estimate are chosen among those of all bodies; where
/// Graded hp cuts one side of a contact, the other follows.
std::vector<adaptivity::Marks> marksOf(const BodySpaces& spaces, const Level& level,
                                       const bem::Processes& processes) {
  const Scene& scene = spaces.scene();
  const std::vector<StepFields> steps = loaded(level.steps);
  const std::vector<SingularMesh> meshes = singularMeshes(spaces, steps);
  const adaptivity::Strategy& strategy = strategyOf(scene);
  std::vector<bem::Vector> squares;
  for (const adaptivity::Indicators& ofBody : level.indicators)
    squares.push_back(ofBody.elements());
  auto worst = adaptivity::doerfler(squares, scene.adaptivity.strategy.markingFraction);
  if (strategy.grading == adaptivity::Grading::Obeyed)
    worst = withFacing(scene, meshes, std::move(worst));
  std::vector<adaptivity::Marks> marks;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const adaptivity::LevelData data{meshes[b].mesh, worst[b],
                                     analyticIn(steps, b, spaces), meshes[b].singular,
                                     gradingOf(scene)};
    marks.push_back(adaptivity::decide(strategy, data, processes));
  }
  return marks;
}

bool isReached(const Scene& scene, const Level& level) {
  const auto& tolerance = scene.adaptivity.limits.tolerance;
  return tolerance && level.relativeEstimate <= *tolerance;
}

/// What is reached of Adaptivity->Tolerance.
std::string reached(const Scene& scene, const Level& level) {
  std::ostringstream text;
  text << std::setprecision(3) << "the estimated error is "
       << 100 * level.relativeEstimate << " % of the energy norm"
       << (scene.history ? " in the worst step" : "")
       << (isReached(scene, level) ? ", within" : ", above")
       << " Adaptivity->Tolerance = " << *scene.adaptivity.limits.tolerance;
  return text.str();
}

/// Is there a state under the first load?  Not where the first step of a path was solved in parts.
bool hasFirst(const Scene& scene, const Level& level) {
  return !scene.history || level.path.front().t == scene.history.times.front();
}

/// The state from which the next level starts: under the load, or in the first step of a path.
StepFields carryFirst(const BodySpaces& spaces, const Level& level, const Level& next) {
  const Scene& scene = spaces.scene();
  StepFields start;
  start.rigid = level.steps.front().rigid;
  const contact::Numbering numbering(spaces.sides());
  std::size_t motions = 0;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    contact::State state = level.last().own[b];
    if (scene.history) {
      const contact::State& first = level.path.front().state;
      state.multiplier = numbering.of(b, first.multiplier);
      for (double& motion : state.rigid)
        motion = first.rigid[motions++];
    }
    start.own.push_back(adaptivity::carry(
        spaces.space(b).mesh(), spaces.multiplier(b), state,
        {scene.bodies[b].outline, next.meshes[b]}, scene.bodies[b].conditions));
  }
  return start;
}

}  // namespace

std::string missingTo(const Scene& scene, const Level& level) {
  return scene.adaptivity.limits.tolerance && !isReached(scene, level)
             ? "; " + reached(scene, level)
             : "";
}

std::variant<Level, Outcome> nextLevel(const Scene& scene, const Level& level,
                                       const bem::Processes& processes) {
  const auto converged = [&](const std::string& reason) {
    return Outcome{contact::Status::Converged, reason + missingTo(scene, level)};
  };
  if (level.status != contact::Status::Converged)
    return Outcome{level.status, bem::message("level ", level.number,
                                              " is not converged: ", level.reason)};
  if (isReached(scene, level))
    return converged(reached(scene, level));
  if (level.estimate() < scene.adaptivity.limits.estimate)
    return converged("the estimate is below the target");
  if (level.number + 1 >= scene.adaptivity.limits.levels)
    return converged("all levels that the scene allows are computed");

  const BodySpaces spaces(scene, level);
  const std::vector<adaptivity::Marks> marks = marksOf(spaces, level, processes);
  if (std::none_of(marks.begin(), marks.end(), adaptivity::anyMarked))
    return converged("there is nothing to refine");

  Level next{level.number + 1};
  for (std::size_t b = 0; b < spaces.size(); ++b)
    next.meshes.push_back(piecesOf(adaptivity::refine(spaces.space(b).mesh(), marks[b])));
  if (strategyOf(scene).start == adaptivity::Start::Carried && hasFirst(scene, level))
    next.steps = {carryFirst(spaces, level, next)};
  return next;
}

std::variant<Level, Outcome> levelAfterRestart(const Scene& scene, const Level& level,
                                               const bem::Processes& processes) {
  if (level.status != contact::Status::Converged || !level.complete) {
    Level again = level;
    if (scene.history)  // whose last state is not that of the first step
      again.steps.clear();
    return again;
  }
  return nextLevel(scene, level, processes);
}

}  // namespace epafi::drivers
