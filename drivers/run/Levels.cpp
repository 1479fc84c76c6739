#include "drivers/run/Levels.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "bem/base/Error.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/equation/ContactState.hpp"
#include "contact/problem/CompressedBody.hpp"
#include "contact/problem/ContactSystem.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Forecast.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/Resistance.hpp"
#include "drivers/run/Solver.hpp"

namespace epafi::drivers {

namespace {

/// A body's own part of the states of all coefficients.
contact::ContactState ofBody(const contact::Numbering& numbering, std::size_t b,
                             const contact::ContactState& all) {
  contact::ContactState own;
  for (bem::Index i = 0; i < numbering.sizeOf(b); ++i) {
    const bem::Index k = numbering(b, i);
    if (k < numbering.normals())
      own.normal.push_back(all.normal[static_cast<std::size_t>(k)]);
    else
      own.tangential.push_back(
          all.tangential[static_cast<std::size_t>(k - numbering.normals())]);
  }
  return own;
}

/// The smallest that a body with stabilised contact has got; zero if there is none.
double gamma0Of(const contact::ContactSystem& system) {
  double smallest = 0;
  for (std::size_t b = 0; b < system.size(); ++b) {
    const double own = system.body(b).gamma0();
    if (own > 0 && (smallest == 0 || own < smallest))
      smallest = own;
  }
  return smallest;
}

LevelRow makeRow(const Level& level, const Size& size, double gamma0,
                 const std::vector<contact::Solved>& solved,
                 const contact::Report& report, const PhaseTimer& timer) {
  LevelRow row;
  row.level = level.number;
  row.size = size;
  row.bodies = contact::summarizeAll(solved);
  row.summary = contact::sumOf(row.bodies);
  row.report = report;
  row.reason = level.reason;
  row.gamma0 = gamma0;
  row.estimate = level.estimate();
  row.squares = level.squares();
  const bem::Vector cost = largestOverRanks(
      solved.front().stiffness.algebra(),
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

/// Are a level's operators compressed?
bool compresses(const Scene& scene, const Size& size, const Ranks& ranks) {
  using Operators = LinearMethod::Operators;
  const Operators wanted = linearMethods().at(scene.linear.method).operators;
  if (wanted == Operators::Compressed && ranks.algebra().processes() > 1)
    throw bem::InputError(bem::message(
        "Solver->Linear->Method = ", scene.linear.method,
        ": operators are compressed on one process only; start epafi without mpirun, or "
        "choose Dense, Belos or Automatic"));
  if (wanted != Operators::Cheaper)
    return wanted == Operators::Compressed;
  // unknowns from which compressed operators cost less, see doc/benchmarks/compression.md
  constexpr bem::Index crossover = 6000;
  return ranks.algebra().processes() == 1 && whyNotCompressed(scene).empty() &&
         size.displacements + size.densities > crossover;
}

std::vector<bem::Piece> piecesOf(const bem::Mesh& mesh) {
  std::vector<bem::Piece> pieces;
  for (const bem::Element& element : mesh.elements())
    pieces.push_back(element.piece);
  return pieces;
}

/// A level whose path is followed.
struct PathLevel {
  const Scene& scene;
  int number;
  const Size& size;
  const bem::Lame& lame;
  PhaseTimer& timer;
};

/// Receivers of the level and of its steps.
struct HandOuts {
  const std::function<void(const SolvedLevel&)>& level;
  const std::function<void(const SolvedLevel&)>& step;
};

/// The level at the end of the path so far; everything but the indicators.
Level levelOf(int number, const contact::Solved& solved, const Path& path) {
  Level level{number, path.report.status, path.reason, {}};
  level.bodies.push_back({piecesOf(solved.space.mesh()), solved.state,
                          contact::classify(solved.problem.numbers(), solved.state),
                          solved.displacement, path.steps.back()->density});
  level.path = path.points;
  return level;
}

/// The largest indicators over the steps.
adaptivity::Indicators estimatePath(const Path& path, const PathLevel& ground,
                                    const PathGround& on) {
  std::vector<adaptivity::Indicators> all;
  for (std::size_t k = 0; k < path.steps.size(); ++k)
    all.push_back(adaptivity::estimateResidual(solvedStep(on, path, k),
                                               path.steps[k]->density, ground.lame,
                                               ground.scene.adaptivity.estimator));
  return adaptivity::largest(all);
}

/// Levels outside, steps inside: the whole path on one mesh.
Level solvePath(const PathLevel& ground, const bem::SteklovPoincare& stiffness,
                const BodySpaces& spaces, const std::vector<PathPoint>& earlier,
                const HandOuts& handOuts) {
  const Scene& scene = ground.scene;
  PhaseTimer& timer = ground.timer;
  const bem::Units units = scene.units();
  const contact::Conditions start = scene.conditionsAt(0);
  const auto atZero = timer.run(Phase::Stabilization, [&] {
    return contact::ContactProblem({spaces.space(0), stiffness, ground.lame, units, start,
                                    contact::multiplierBasis(scene.multiplier),
                                    scene.stabilization});
  });
  const PathGround on{scene, ground.number, spaces.space(0), stiffness, atZero, units};
  const auto lastOf = [&](const Path& path) {
    return std::vector<contact::Solved>{solvedStep(on, path, path.steps.size() - 1)};
  };
  const Path path = followPath(on, earlier, timer, [&](const Path& sofar) {
    if (!handOuts.step)
      return;
    const std::vector<contact::Solved> solved = lastOf(sofar);
    Level level = levelOf(ground.number, solved.front(), sofar);
    level.complete = false;
    level.bodies.front().indicators.squares.resize(
        static_cast<std::size_t>(on.space.mesh().size()));
    timer.run(Phase::Results, [&] { handOuts.step({solved, level, {}, &sofar}); });
  });
  const std::vector<contact::Solved> solved = lastOf(path);
  Level level = levelOf(ground.number, solved.front(), path);
  level.bodies.front().indicators =
      timer.run(Phase::Estimate, [&] { return estimatePath(path, ground, on); });
  timer.run(Phase::Results, [&] {
    LevelRow row =
        makeRow(level, ground.size, atZero.gamma0(), solved, path.report, timer);
    row.summary.energyFriction = path.steps.back()->row.energyDissipated;
    row.bodies.front().energyFriction = row.summary.energyFriction;
    handOuts.level({solved, level, row, &path});
  });
  return level;
}

}  // namespace

Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier,
                    const std::function<void(const SolvedLevel&)>& handOutStep) {
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const bem::Units units = scene.units();
  const bem::DenseAlgebra& algebra = ranks.algebra();
  const auto krylov = linearMethods().at(scene.linear.method).solver(ranks, scene.linear);
  const std::size_t count = scene.bodies.size();
  std::vector<bem::Lame> lames;
  for (std::size_t b = 0; b < count; ++b)
    lames.push_back(scene.lame(b));

  auto next = earlier ? levelAfterRestart(scene, *earlier, algebra) : firstLevel(scene);
  while (const auto* from = std::get_if<LevelStart>(&next)) {
    const int number = from->level;
    const BodySpaces spaces(scene, from->meshes);
    Size size = spaces.sizes();
    size.memory = forecastMemory(spaces, algebra.processes());
    if (size.dof() > scene.adaptivity.limits.degreesOfFreedom)
      return {contact::Status::Converged,
              capReached(number, size, scene.adaptivity.limits.degreesOfFreedom)};
    if (const auto reason =
            tooLarge(number, size, size.memory, scene.adaptivity.limits.memory, ranks))
      return {contact::Status::Converged, *reason};
    timer.startLevel(number);

    const bool compressed = compresses(scene, size, ranks);
    auto operators = timer.run(Phase::Assembly, [&] {
      std::vector<bem::Operators> all;
      for (std::size_t b = 0; b < count && !compressed; ++b)
        all.push_back(bem::withExactRotation(
            bem::assembleOperators(
                spaces.space(b), lames[b], algebra,
                contact::tractionElements(spaces.multiplier(b), scene.stabilization)),
            spaces.space(b), algebra));
      return all;
    });
    const auto stiffness = timer.run(Phase::Factorization, [&] {
      std::vector<bem::SteklovPoincare> all;
      if (compressed)
        all.push_back(contact::makeCompressedStiffness(
            spaces.space(0), spaces.multiplier(0), scene.stabilization, lames.front(),
            units, algebra, scene.linear.compression));
      for (std::size_t b = 0; b < count && !compressed; ++b)
        all.push_back(stiffnessOf(
            std::move(operators[b]), algebra, krylov.get(),
            contact::densityCompliance(spaces.space(b), spaces.multiplier(b),
                                       scene.stabilization, lames[b], units)));
      return all;
    });
    if (scene.history) {
      const Level level =
          solvePath({scene, number, size, lames.front(), timer}, stiffness.front(),
                    spaces, from->path, {handOut, handOutStep});
      timer.endLevel();
      next = nextLevel(scene, level, algebra);
      continue;
    }
    const auto system = timer.run(Phase::Stabilization, [&] {
      std::vector<contact::ContactProblem::Input> inputs;
      for (std::size_t b = 0; b < count; ++b)
        inputs.push_back({spaces.space(b), stiffness[b], lames[b], units,
                          scene.bodies[b].conditions, basis, scene.stabilization,
                          spaces.opposite(b)});
      return contact::ContactSystem(inputs);
    });
    checkResistance(scene, system);
    const Solved outcome = timer.run(Phase::Newton, [&] {
      return solve(system, spaces, system.joined(from->start), scene.solver, algebra);
    });

    const contact::Solution& solution = outcome.solution;
    Level level{number, solution.report.status, outcome.reason, {}};
    const std::vector<contact::State> states = system.split(solution.state);
    const contact::ContactState kinds =
        contact::classify(system.numbers(), solution.state);
    std::vector<bem::Vector> met;
    std::vector<const bem::Vector*> displacements;
    level.bodies.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
      met.push_back(system.met(b, states));
      const bem::Vector u = system.body(b).displacement(states[b], met[b]);
      const bem::Vector density = system.body(b).density(states[b], u);
      level.bodies[b] = {piecesOf(spaces.space(b).mesh()), states[b],
                         ofBody(system.numbering(), b, kinds), u, density};
      displacements.push_back(&level.bodies[b].displacement);
    }
    const contact::Motions motions = spaces.motions(displacements);
    std::vector<contact::Solved> solved;
    for (std::size_t b = 0; b < count; ++b)
      solved.push_back({spaces.space(b),
                        stiffness[b],
                        system.body(b),
                        scene.bodies[b].conditions,
                        units,
                        level.bodies[b].state,
                        level.bodies[b].displacement,
                        met[b],
                        {},
                        &motions});
    for (std::size_t b = 0; b < count; ++b)
      solved[b].pressed = contact::pressureOn(b, solved);
    timer.run(Phase::Estimate, [&] {
      for (std::size_t b = 0; b < count; ++b)
        level.bodies[b].indicators = adaptivity::estimateResidual(
            solved[b], level.bodies[b].density, lames[b], scene.adaptivity.estimator);
    });
    timer.run(Phase::Results, [&] {
      handOut({solved, level,
               makeRow(level, size, gamma0Of(system), solved, solution.report, timer)});
    });
    timer.endLevel();
    next = nextLevel(scene, level, algebra);
  }
  return std::get<Outcome>(next);
}

}  // namespace epafi::drivers
