#include "drivers/Levels.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "adaptivity/mark/Analyticity.hpp"
#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/refine/Strategy.hpp"
#include "bem/assembly/SteklovPoincare.hpp"
#include "bem/base/Error.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "drivers/Ranks.hpp"
#include "drivers/SolveOnce.hpp"

namespace epafi::drivers {

namespace {

LevelRow makeRow(int level, const Size& size, const contact::Solved& solved,
                 const contact::Report& report, const adaptivity::Indicators& indicators,
                 const PhaseTimer& timer) {
  LevelRow row;
  row.level = level;
  row.size = size;
  row.summary = contact::summarize(solved);
  row.report = report;
  row.estimate = indicators.estimate();
  row.squares = indicators.sums();
  const bem::Vector cost = largestOverRanks(
      solved.stiffness.algebra(),
      {timer.levelSeconds(Phase::Assembly), timer.levelSeconds(Phase::Factorization),
       timer.levelSeconds(Phase::Stabilization), timer.levelSeconds(Phase::Newton),
       timer.levelSeconds(Phase::Estimate), cpuSeconds(), timer.wallSeconds(),
       peakMemory()});
  row.seconds.assembly = cost[0];
  row.seconds.factorization = cost[1];
  row.seconds.stabilization = cost[2];
  row.seconds.newton = cost[3];
  row.seconds.estimate = cost[4];
  row.secondsTotal = cost[5];
  row.secondsWall = cost[6];
  row.memory = cost[7];
  return row;
}

std::string capReached(int level, const Size& size, long cap) {
  std::string text =
      bem::message("level ", level, " would have ", size.dof(),
                   " degrees of freedom; Adaptivity->Maximum Degrees of Freedom = ", cap);
  if (level == 0)
    throw bem::InputError(text + " does not allow a single level");
  return text;
}

}  // namespace

Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut) {
  const adaptivity::Strategy& strategy = adaptivity::strategy(scene.adaptivity.strategy);
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const bem::Units units{scene.outline->diameter(), scene.material.youngsModulus};
  const bem::Lame lame(scene.material);
  const bem::DenseAlgebra& algebra = ranks.algebra();
  const auto belos = scene.linear.method == Scene::Linear::Method::Belos
                         ? ranks.belosSolver(scene.linear.belos)
                         : nullptr;

  bem::Mesh mesh = bem::makeMesh(scene.outline, scene.elementsPerEdge, scene.degree);
  contact::State start;  // empty: from zero

  for (int level = 0;; ++level) {
    const bem::Space space(mesh);
    const contact::MultiplierSpace multiplier(mesh, basis, scene.conditions);
    const Size size = sizeOf(space, multiplier, scene.conditions);
    if (size.dof() > scene.adaptivity.maximumDegreesOfFreedom)
      return {contact::Status::Converged,
              capReached(level, size, scene.adaptivity.maximumDegreesOfFreedom)};
    timer.startLevel(level);

    auto operators = timer.run(Phase::Assembly, [&] {
      return bem::assembleOperators(
          space, lame, algebra,
          contact::tractionElements(multiplier, scene.stabilization));
    });
    const auto stiffness = timer.run(Phase::Factorization, [&] {
      if (belos != nullptr)
        return bem::SteklovPoincare(std::move(operators), algebra, *belos);
      return bem::SteklovPoincare(std::move(operators), algebra);
    });
    const auto problem = timer.run(Phase::Stabilization, [&] {
      return contact::ContactProblem(
          {space, stiffness, lame, units, scene.conditions, basis, scene.stabilization});
    });
    const auto solution = timer.run(
        Phase::Newton, [&] { return solveOnce(problem, start, scene.solver, algebra); });
    const bem::Vector displacement = problem.displacement(solution.state);
    const bem::Vector density = stiffness.density(displacement);
    const contact::Solved solved{space, stiffness,      problem,     scene.conditions,
                                 units, solution.state, displacement};
    const auto indicators = timer.run(Phase::Estimate, [&] {
      return adaptivity::estimateResidual(solved, density, lame,
                                          scene.adaptivity.estimator);
    });
    timer.run(Phase::Results, [&] {
      handOut({solved, density,
               makeRow(level, size, solved, solution.report, indicators, timer)});
    });
    timer.endLevel();

    if (solution.report.status != contact::Status::Converged)
      return {
          solution.report.status,
          bem::message("level ", level, " is not converged: ", solution.report.reason)};
    if (indicators.estimate() < scene.adaptivity.targetEstimate)
      return {contact::Status::Converged, "the estimate is below the target"};
    if (level + 1 == scene.adaptivity.maximumLevels)
      return {contact::Status::Converged,
              "all levels that the scene allows are computed"};
    const adaptivity::LevelData data{
        mesh, indicators.elements(),
        adaptivity::looksAnalytic(space, scene.conditions, displacement, density,
                                  scene.adaptivity.analyticityThreshold),
        scene.adaptivity.markingFraction,
        adaptivity::findSingularPoints(mesh, scene.conditions, problem.multiplier(),
                                       problem.numbers(), solution.state)};
    const adaptivity::Marks marks = adaptivity::decide(strategy, data, algebra);
    if (!adaptivity::anyMarked(marks))
      return {contact::Status::Converged, "there is nothing to refine"};
    adaptivity::Refined refined = adaptivity::refine(mesh, marks, problem.multiplier(),
                                                     scene.conditions, solution.state);
    mesh = std::move(refined.mesh);
    if (strategy.start == adaptivity::Start::Carried)
      start = std::move(refined.start);
  }
}

}  // namespace epafi::drivers
