#include "drivers/NextLevel.hpp"

#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/refine/Strategy.hpp"
#include "bem/base/Error.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::drivers {

LevelStart firstLevel(const Scene& scene) {
  return {0, bem::makeMesh(scene.outline, scene.elementsPerEdge, scene.degree), {}};
}

std::variant<LevelStart, Outcome> nextLevel(const Scene& scene, const LevelResult& result,
                                            const bem::DenseAlgebra& algebra) {
  const auto converged = [](const char* reason) {
    return Outcome{contact::Status::Converged, reason};
  };
  if (result.status != contact::Status::Converged)
    return Outcome{result.status, bem::message("level ", result.level,
                                               " is not converged: ", result.reason)};
  if (result.indicators.estimate() < scene.adaptivity.targetEstimate)
    return converged("the estimate is below the target");
  if (result.level + 1 >= scene.adaptivity.maximumLevels)
    return converged("all levels that the scene allows are computed");

  const bem::Space space({scene.outline, result.pieces});
  const bem::Mesh& mesh = space.mesh();
  const adaptivity::Strategy& strategy = adaptivity::strategy(scene.adaptivity.strategy);
  const contact::MultiplierSpace multiplier(
      mesh, contact::multiplierBasis(scene.multiplier), scene.conditions);
  const adaptivity::LevelData data{
      mesh,
      result.indicators.elements(),
      adaptivity::looksAnalytic(space, scene.conditions, result.displacement,
                                result.density, scene.adaptivity.analyticityThreshold),
      scene.adaptivity.markingFraction,
      scene.adaptivity.grading.transitions == "Ignore"
          ? adaptivity::findSingularPoints(mesh, scene.conditions)
          : adaptivity::findSingularPoints(mesh, scene.conditions, multiplier,
                                           result.states),
      scene.adaptivity.grading};
  const adaptivity::Marks marks = adaptivity::decide(strategy, data, algebra);
  if (!adaptivity::anyMarked(marks))
    return converged("there is nothing to refine");

  adaptivity::Refined refined =
      adaptivity::refine(mesh, marks, multiplier, scene.conditions, result.state);
  LevelStart next{result.level + 1, std::move(refined.mesh), {}};
  if (strategy.start == adaptivity::Start::Carried)
    next.start = std::move(refined.start);
  return next;
}

std::variant<LevelStart, Outcome> levelAfterRestart(const Scene& scene,
                                                    const LevelResult& result,
                                                    const bem::DenseAlgebra& algebra) {
  if (result.status != contact::Status::Converged)
    return LevelStart{result.level, {scene.outline, result.pieces}, result.state};
  return nextLevel(scene, result, algebra);
}

}  // namespace epafi::drivers
