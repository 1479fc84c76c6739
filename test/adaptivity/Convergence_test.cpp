// The two scenes of [P] sec. 8: rates of the estimate, the estimate beside true errors, and
// Newton's steps.
#include "bem/operators/EnergyNorm.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace epafi {

namespace {

struct Level {
  double dof = 0;
  double estimate = 0;
  int steps = 0;  ///< linear systems solved; -1: not converged
  bem::CauchyData solution;
};

drivers::Scene sceneOf(const std::string& name,
                       const std::vector<std::string>& settings = {}) {
  return drivers::readScene(std::string(EPAFI_SCENES) + "/" + name + ".xml", settings);
}

std::vector<Level> solveScene(const std::string& name,
                              const std::vector<std::string>& settings) {
  const drivers::Scene scene = sceneOf(name, settings);
  std::vector<Level> levels;
  drivers::PhaseTimer timer;
  const drivers::Ranks ranks;
  const auto keep = [&](const drivers::SolvedLevel& level) {
    const contact::Report& report = level.row.report;
    levels.push_back({static_cast<double>(level.row.dof()), level.row.estimate,
                      report.converged() ? report.newtonIterations : -1,
                      bem::makeCauchyData(level.last().bodies[0].space,
                                          level.last().bodies[0].displacement,
                                          level.last().densities[0])});
  };
  solveLevels(scene, ranks, timer, keep);
  return levels;
}

std::vector<std::string> with(std::vector<std::string> settings,
                              const std::string& strategy, int levels, int dof) {
  settings.push_back("Adaptivity->Strategy=" + strategy);
  settings.push_back(std::string("Adaptivity->Marking Fraction=") +
                     (strategy == "Graded hp" ? "0.6" : "0.3"));
  settings.push_back("Adaptivity->Maximum Levels=" + std::to_string(levels));
  settings.push_back("Adaptivity->Maximum Degrees of Freedom=" + std::to_string(dof));
  return settings;
}

const std::vector<std::string> paper = {
    "Adaptivity->Weights=Paper", "Discretization->Multiplier=Gauss-Lobatto-Lagrange",
    "Discretization->Stabilization->Gamma0=1e-3",
    "Discretization->Stabilization->Scaling=Absolute"};

const std::vector<std::string> quadratic = {"Discretization->Degree=2"};
const std::vector<std::string> ownStabilization = {
    "Discretization->Stabilization->Scaling=Stiffness",
    "Discretization->Stabilization->Gamma0=0.1"};
const std::vector<std::string> stabilised = {"Discretization->Degree=2",
                                             ownStabilization[0], ownStabilization[1]};
const std::vector<std::string> biorthogonal = {
    "Discretization->Degree=2", "Discretization->Multiplier=Biorthogonal",
    "Discretization->Stabilization->Form=None"};

/// Slope of -log(estimate) against log(dof), least squares over the last two thirds.
double rateOf(const std::vector<Level>& levels) {
  const std::size_t first = levels.size() / 3;
  const auto count = static_cast<double>(levels.size() - first);
  double mx = 0;
  double my = 0;
  for (std::size_t k = first; k < levels.size(); ++k) {
    mx += std::log(levels[k].dof) / count;
    my += std::log(levels[k].estimate) / count;
  }
  double product = 0;
  double square = 0;
  for (std::size_t k = first; k < levels.size(); ++k) {
    const double x = std::log(levels[k].dof) - mx;
    product += x * (std::log(levels[k].estimate) - my);
    square += x * x;
  }
  return -product / square;
}

double smallestEstimate(const std::vector<Level>& levels, double dof) {
  double smallest = levels.front().estimate;
  for (const Level& level : levels)
    if (level.dof <= dof)
      smallest = std::min(smallest, level.estimate);
  return smallest;
}

/// The root of an energy of 1, in the scene's units.
double energyUnit(const drivers::Scene& scene) {
  return std::sqrt(scene.bodies[0].material.youngsModulus) *
         scene.bodies[0].outline->diameter();
}

}  // namespace

TEUCHOS_UNIT_TEST(Rates, ofTrescasBlockAreThePapers) {
  const double uniform =
      rateOf(solveScene("tresca", with(paper, "Uniform h", 6, 100000)));
  TEST_COMPARE(uniform, >=, 0.45);
  TEST_COMPARE(uniform, <=, 0.6);
  TEST_COMPARE(rateOf(solveScene("tresca", with(paper, "Adaptive h", 60, 1600))), >=,
               1.55);
  const auto hp = solveScene("tresca", with(paper, "Adaptive hp", 60, 900));
  TEST_COMPARE(rateOf(hp), >=, 2.2);
  TEST_COMPARE(smallestEstimate(hp, 660), <=, 4e-4);
}

TEUCHOS_UNIT_TEST(Rates, ofCoulombsBlockAreThePapers) {
  for (const auto& settings :
       {with(paper, "Uniform h", 5, 100000), with(paper, "Adaptive h", 60, 1600)}) {
    const double rate = rateOf(solveScene("coulomb", settings));
    TEST_COMPARE(rate, >=, 1.35);
    TEST_COMPARE(rate, <=, 1.6);
  }
  const auto hp = solveScene("coulomb", with(paper, "Adaptive hp", 60, 900));
  TEST_COMPARE(rateOf(hp), >=, 2.5);
  TEST_COMPARE(smallestEstimate(hp, 870), <=, 2e-4);
}

// The reference is a much finer level of the same strategy; levels less than ten times as
// far from it as its own estimate says nothing certain.
TEUCHOS_UNIT_TEST(Effectivity, inEnergyWeightsStaysBetweenOneAndAHalfAndFourAndAHalf) {
  for (const char* name : {"tresca", "coulomb"}) {
    const std::vector<Level> fine = solveScene(name, with({}, "Graded hp", 100, 1600));
    const bem::CauchyData& reference = fine.back().solution;
    const drivers::Scene scene = sceneOf(name);
    const bem::Lame lame(scene.bodies[0].material);
    out << name << ", reference: " << fine.back().dof << " unknowns, estimate "
        << fine.back().estimate << "\n";
    for (const auto& settings :
         {with({}, "Uniform h", 5, 100000), with(quadratic, "Uniform h", 6, 100000),
          with(stabilised, "Uniform h", 6, 100000),
          with(biorthogonal, "Uniform h", 6, 100000), with({}, "Adaptive h", 60, 900),
          with(quadratic, "Adaptive h", 60, 1500),
          with(biorthogonal, "Adaptive h", 60, 1500), with({}, "Adaptive hp", 60, 900),
          with({}, "Graded hp", 60, 900)}) {
      int outside = 0;
      for (const std::string& setting : settings)
        out << "  " << setting;
      out << "\n";
      for (const Level& level : solveScene(name, settings)) {
        if (level.estimate < 10 * fine.back().estimate)
          break;
        const double error =
            energyUnit(scene) * energyNorm(difference(level.solution, reference), lame);
        const double index = level.estimate / error;
        out << "    " << level.dof << " " << error << " " << index << "\n";
        outside += index < 1.5 || index > 4.5 ? 1 : 0;
      }
      TEST_COMPARE(outside, <=, 1);
    }
  }
}

/// dof of the first level from which on the relative error in the energy norm stays below
/// a bound.
double dofFor(double bound, const std::vector<Level>& levels,
              const bem::CauchyData& reference, const bem::Lame& lame) {
  const double scale = energyNorm(reference, lame);
  double dof = std::numeric_limits<double>::infinity();
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    if (energyNorm(difference(level->solution, reference), lame) > bound * scale)
      break;
    dof = level->dof;
  }
  return dof;
}

TEUCHOS_UNIT_TEST(GradedHp, convergesExponentiallyInTheRootOfDof) {
  struct Goal {
    const char* scene;
    double dof[3];  // for 1e-3, 1e-4, 1e-5
  };
  for (const Goal& goal :
       {Goal{"tresca", {550, 900, 1400}}, Goal{"coulomb", {400, 650, 950}}}) {
    const auto levels = solveScene(goal.scene, with({}, "Graded hp", 100, 1700));
    const auto fine = solveScene(goal.scene, with({}, "Graded hp", 100, 2300));
    const drivers::Scene scene = sceneOf(goal.scene);
    const bem::Lame lame(scene.bodies[0].material);
    const bem::CauchyData& reference = fine.back().solution;
    out << goal.scene << ", reference: " << fine.back().dof << " unknowns, estimate "
        << fine.back().estimate << "\n";
    double bound = 1e-3;
    for (const double dof : goal.dof) {
      out << "  " << bound << " at " << dofFor(bound, levels, reference, lame)
          << " dof\n";
      TEST_COMPARE(dofFor(bound, levels, reference, lame), <=, dof);
      bound *= 0.1;
    }
  }
}

// Newton's steps on all levels but the first, each started from the state carried over.
TEUCHOS_UNIT_TEST(WarmStart, needsFewStepsInTheMedianAndBoundedOnesAtMost) {
  for (const auto& [multiplier, most] :
       std::vector<std::pair<std::string, int>>{{"Gauss-Legendre-Lagrange", 8},
                                                {"Gauss-Lobatto-Lagrange", 20},
                                                {"Bernstein", 20}})
    for (const char* scene : {"tresca", "coulomb"}) {
      std::vector<int> all;
      for (const char* strategy : {"Graded hp", "Adaptive h", "Adaptive hp"})
        for (const bool own : {false, true}) {
          std::vector<std::string> settings = {"Discretization->Multiplier=" +
                                               multiplier};
          if (own)
            settings.insert(settings.end(), ownStabilization.begin(),
                            ownStabilization.end());
          const auto levels = solveScene(scene, with(settings, strategy, 100, 1500));
          int largest = 0;
          for (std::size_t k = 1; k < levels.size(); ++k) {
            TEST_COMPARE(levels[k].steps, >=, 0);
            largest = std::max(largest, levels[k].steps);
            all.push_back(levels[k].steps);
          }
          out << multiplier << ", " << scene << ", " << strategy
              << (own ? ", own" : ", the paper's") << " stabilisation: " << levels.size()
              << " levels, at most " << largest << " steps\n";
          TEST_COMPARE(largest, <=, most);
        }
      const auto middle =
          std::next(all.begin(), static_cast<std::ptrdiff_t>(all.size() / 2));
      std::nth_element(all.begin(), middle, all.end());
      out << scene << ", median " << *middle << "\n";
      TEST_COMPARE(*middle, <=, 3);
    }
}

}  // namespace epafi
