#include "drivers/run/NextLevel.hpp"

#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/mark/Strategy.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/ContactProblem.hpp"

namespace epafi::drivers {

LevelStart firstLevel(const Scene& scene) {
  return {0, bem::makeMesh(scene.outline, scene.elementsPerEdge, scene.degree), {}};
}

std::variant<LevelStart, Outcome> nextLevel(const Scene& scene, const Level& level,
                                            const bem::DenseAlgebra& algebra) {
  const auto converged = [](const char* reason) {
    return Outcome{contact::Status::Converged, reason};
  };
  if (level.status != contact::Status::Converged)
    return Outcome{level.status, bem::message("level ", level.number,
                                              " is not converged: ", level.reason)};
  if (level.indicators.estimate() < scene.adaptivity.limits.estimate)
    return converged("the estimate is below the target");
  if (level.number + 1 >= scene.adaptivity.limits.levels)
    return converged("all levels that the scene allows are computed");

  const bem::Space space = contact::makeSpace({scene.outline, level.pieces},
                                              scene.conditions, scene.stabilization);
  const bem::Mesh& mesh = space.mesh();
  const adaptivity::StrategyOptions& options = scene.adaptivity.strategy;
  const adaptivity::Strategy& strategy = adaptivity::strategy(options.name);
  const contact::MultiplierSpace multiplier(
      mesh, contact::multiplierBasis(scene.multiplier), scene.conditions);
  adaptivity::GradingOptions grading = options.grading;
  grading.largestDegree = multiplier.basis().largestDegree;
  const bem::Mesh coarse = firstLevel(scene).mesh;
  const adaptivity::SolvedMesh solved{space,        scene.conditions,   multiplier,
                                      level.states, level.displacement, coarse};
  const adaptivity::PreparedMesh prepared =
      adaptivity::prepare(strategy, solved, grading, algebra);
  const adaptivity::LevelData data{
      prepared.mesh,
      level.indicators.elements(),
      adaptivity::looksAnalytic(space, scene.conditions, level.displacement,
                                level.density, options.analyticityThreshold),
      options.markingFraction,
      prepared.singular,
      grading};
  const adaptivity::Marks marks = adaptivity::decide(strategy, data, algebra);
  if (!adaptivity::anyMarked(marks))
    return converged("there is nothing to refine");

  LevelStart next{level.number + 1, adaptivity::refine(prepared.mesh, marks), {}};
  if (strategy.start == adaptivity::Start::Carried)
    next.start =
        adaptivity::carry(mesh, multiplier, level.state, next.mesh, scene.conditions);
  return next;
}

std::variant<LevelStart, Outcome> levelAfterRestart(const Scene& scene,
                                                    const Level& level,
                                                    const bem::DenseAlgebra& algebra) {
  if (level.status != contact::Status::Converged)
    return LevelStart{level.number, {scene.outline, level.pieces}, level.state};
  return nextLevel(scene, level, algebra);
}

}  // namespace epafi::drivers
