// Newton's steps on the levels of adaptive runs, each started from the state carried
// over.
#include "drivers/process/Ranks.hpp"
#include "drivers/run/Levels.hpp"
#include "drivers/scene/SceneReader.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace epafi {

namespace {

/// Linear systems solved on each level but the first; -1 on one that has not converged.
std::vector<int> warmSteps(const std::string& scene,
                           const std::vector<std::string>& settings) {
  std::vector<int> steps;
  drivers::PhaseTimer timer;
  const drivers::Ranks ranks;
  solveLevels(
      drivers::readScene(std::string(EPAFI_SCENES) + "/" + scene + ".xml", settings),
      ranks, timer, [&](const drivers::SolvedLevel& level) {
        const contact::Report& report = level.row.report;
        steps.push_back(
            report.status == contact::Status::Converged ? report.newtonIterations : -1);
      });
  steps.erase(steps.begin());
  return steps;
}

std::vector<std::string> sequence(const std::string& multiplier,
                                  const std::string& strategy,
                                  const std::string& fraction) {
  return {"Discretization->Multiplier=" + multiplier, "Adaptivity->Strategy=" + strategy,
          "Adaptivity->Marking Fraction=" + fraction, "Adaptivity->Maximum Levels=100",
          "Adaptivity->Maximum Degrees of Freedom=1500"};
}

const std::vector<std::string> ownStabilization = {
    "Discretization->Stabilization->Scaling=Stiffness",
    "Discretization->Stabilization->Gamma0=0.1"};

}  // namespace

TEUCHOS_UNIT_TEST(WarmStart, needsFewStepsInTheMedianAndBoundedOnesAtMost) {
  for (const auto& [multiplier, most] :
       std::vector<std::pair<const char*, int>>{{"Gauss-Legendre-Lagrange", 8},
                                                {"Gauss-Lobatto-Lagrange", 20},
                                                {"Bernstein", 20}})
    for (const char* scene : {"tresca", "coulomb"}) {
      std::vector<int> all;
      for (const auto& settings : {sequence(multiplier, "Graded hp", "0.6"),
                                   sequence(multiplier, "Adaptive h", "0.3"),
                                   sequence(multiplier, "Adaptive hp", "0.3")})
        for (const bool own : {false, true}) {
          std::vector<std::string> with = settings;
          if (own)
            with.insert(with.end(), ownStabilization.begin(), ownStabilization.end());
          const std::vector<int> steps = warmSteps(scene, with);
          TEST_COMPARE(*std::min_element(steps.begin(), steps.end()), >=, 0);
          TEST_COMPARE(*std::max_element(steps.begin(), steps.end()), <=, most);
          out << multiplier << ", " << scene << ", " << settings[1]
              << (own ? ", own" : ", the paper's") << " stabilisation: " << steps.size()
              << " levels, at most " << *std::max_element(steps.begin(), steps.end())
              << " steps\n";
          all.insert(all.end(), steps.begin(), steps.end());
        }
      const auto middle =
          std::next(all.begin(), static_cast<std::ptrdiff_t>(all.size() / 2));
      std::nth_element(all.begin(), middle, all.end());
      out << scene << ", median " << *middle << "\n";
      TEST_COMPARE(*middle, <=, 3);
    }
}

}  // namespace epafi
