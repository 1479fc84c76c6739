#include "drivers/run/Levels.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "bem/base/Error.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/Solver.hpp"

namespace epafi::drivers {

namespace {

LevelRow makeRow(const Level& level, const Size& size, const contact::Solved& solved,
                 const contact::Report& report, const PhaseTimer& timer) {
  LevelRow row;
  row.level = level.number;
  row.size = size;
  row.summary = contact::summarize(solved);
  row.report = report;
  row.reason = level.reason;
  row.gamma0 = solved.problem.gamma0();
  row.estimate = level.indicators.estimate();
  row.squares = level.indicators.sums();
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

bem::SteklovPoincare stiffnessOf(bem::Operators operators,
                                 const bem::DenseAlgebra& algebra,
                                 const bem::SingleLayerSolver* krylov,
                                 const bem::LocalCompliance& compliance) {
  if (krylov != nullptr)
    return bem::SteklovPoincare(std::move(operators), algebra, *krylov, compliance);
  return bem::SteklovPoincare(std::move(operators), algebra, compliance);
}

std::vector<bem::Piece> piecesOf(const bem::Mesh& mesh) {
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements())
    pieces.push_back(element.piece);
  return pieces;
}

}  // namespace

Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier) {
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const bem::Units units = scene.outline->units(scene.material.youngsModulus);
  const bem::Lame lame(scene.material);
  const bem::DenseAlgebra& algebra = ranks.algebra();
  const auto krylov = linearMethods().at(scene.linear.method).solver(ranks, scene.linear);

  auto next = earlier ? levelAfterRestart(scene, *earlier, algebra) : firstLevel(scene);
  while (const auto* from = std::get_if<LevelStart>(&next)) {
    const int number = from->level;
    const bem::Space space =
        contact::makeSpace(from->mesh, scene.conditions, scene.stabilization);
    const contact::MultiplierSpace multiplier(space.mesh(), basis, scene.conditions);
    const Size size = sizeOf(space, multiplier, scene.conditions);
    if (size.dof() > scene.adaptivity.limits.degreesOfFreedom)
      return {contact::Status::Converged,
              capReached(number, size, scene.adaptivity.limits.degreesOfFreedom)};
    timer.startLevel(number);

    auto operators = timer.run(Phase::Assembly, [&] {
      return bem::withExactRotation(
          bem::assembleOperators(
              space, lame, algebra,
              contact::tractionElements(multiplier, scene.stabilization)),
          space, algebra);
    });
    const auto stiffness = timer.run(Phase::Factorization, [&] {
      return stiffnessOf(std::move(operators), algebra, krylov.get(),
                         contact::densityCompliance(space, multiplier,
                                                    scene.stabilization, lame, units));
    });
    const auto problem = timer.run(Phase::Stabilization, [&] {
      return contact::ContactProblem(
          {space, stiffness, lame, units, scene.conditions, basis, scene.stabilization});
    });
    const auto [solution, reason] = timer.run(Phase::Newton, [&] {
      return solve(problem, space.mesh(), from->start, scene.solver, algebra);
    });
    const bem::Vector displacement = problem.displacement(solution.state);
    const bem::Vector density = problem.density(solution.state, displacement);
    const contact::Solved solved{space, stiffness,      problem,     scene.conditions,
                                 units, solution.state, displacement};
    auto indicators = timer.run(Phase::Estimate, [&] {
      return adaptivity::estimateResidual(solved, density, lame,
                                          scene.adaptivity.estimator);
    });
    const Level level{number,
                      solution.report.status,
                      reason,
                      piecesOf(space.mesh()),
                      solution.state,
                      contact::classify(problem.numbers(), solution.state),
                      displacement,
                      density,
                      std::move(indicators)};
    timer.run(Phase::Results, [&] {
      handOut({solved, level, makeRow(level, size, solved, solution.report, timer)});
    });
    timer.endLevel();
    next = nextLevel(scene, level, algebra);
  }
  return std::get<Outcome>(next);
}

}  // namespace epafi::drivers
