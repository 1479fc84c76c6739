#include "drivers/Levels.hpp"

#include "adaptivity/refine/Refine.hpp"
#include "adaptivity/refine/Strategy.hpp"
#include "bem/algebra/LapackAlgebra.hpp"
#include "bem/assembly/SteklovPoincare.hpp"
#include "bem/base/Error.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "contact/solve/CoulombIteration.hpp"

namespace epafi::drivers {

namespace {

LevelRow makeRow(int level, const Size& size, const contact::Solved& solved,
                 const contact::Report& report, const PhaseTimer& timer) {
  LevelRow row;
  row.level = level;
  row.size = size;
  row.summary = contact::summarize(solved);
  row.report = report;
  row.seconds.assembly = timer.levelSeconds(Phase::Assembly);
  row.seconds.factorization = timer.levelSeconds(Phase::Factorization);
  row.seconds.stabilization = timer.levelSeconds(Phase::Stabilization);
  row.seconds.newton = timer.levelSeconds(Phase::Newton);
  row.secondsTotal = cpuSeconds();
  row.secondsWall = timer.wallSeconds();
  row.memory = peakMemory();
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

Outcome solveLevels(const Scene& scene, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut) {
  const adaptivity::Strategy& strategy = adaptivity::strategy(scene.adaptivity.strategy);
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const bem::Units units{scene.outline->diameter(), scene.material.youngsModulus};
  const bem::Lame lame(scene.material);
  const bem::LapackAlgebra algebra;

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
      return bem::SteklovPoincare(std::move(operators), algebra);
    });
    const auto problem = timer.run(Phase::Stabilization, [&] {
      return contact::ContactProblem(
          {space, stiffness, lame, units, scene.conditions, basis, scene.stabilization});
    });
    const auto solution = timer.run(Phase::Newton, [&] {
      return contact::solve(problem.numbers(), start, scene.solver);
    });
    timer.run(Phase::Results, [&] {
      const bem::Vector displacement = problem.displacement(solution.state);
      const contact::Solved solved{space, stiffness,      problem,     scene.conditions,
                                   units, solution.state, displacement};
      handOut({solved, stiffness.density(displacement),
               makeRow(level, size, solved, solution.report, timer)});
    });
    timer.endLevel();

    if (solution.report.status != contact::Status::Converged)
      return {
          solution.report.status,
          bem::message("level ", level, " is not converged: ", solution.report.reason)};
    if (level + 1 == scene.adaptivity.maximumLevels)
      return {contact::Status::Converged,
              "all levels that the scene allows are computed"};
    const adaptivity::Marks marks = strategy.marks({mesh});
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
