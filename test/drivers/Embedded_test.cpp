// A path that an application follows by the packages alone, as in doc/howto/path, is the program's.
#include "Largest.hpp"
#include "SceneText.hpp"
#include "contact/Solve.hpp"
#include "contact/path/PathMemory.hpp"
#include "contact/path/Prediction.hpp"
#include "contact/solve/Settled.hpp"
#include "contact/stabilization/StabilisedStiffness.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/Levels.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using bem::Vector;

/// A block that Fix holds against tilting rubs on another one and wears; a punch on a spring presses
/// and pushes it.
constexpr const char* rubbing = R"scene({"Rubbing": {
  "Bodies": {
    "base": {"Material": {"Young's Modulus": 1, "Poisson's Ratio": 0.3},
      "Geometry": {"Vertices": [[-1, -1], [1, -1], [1, 0], [-1, 0]],
                   "Edges": ["foot", "right", "face", "left"]},
      "Boundary Conditions": {"foot": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}},
    "block": {"Material": {"Young's Modulus": 2, "Poisson's Ratio": 0.25},
      "Geometry": {"Vertices": [[-0.5, 0], [0.4, 0], [0.4, 0.6], [-0.5, 0.6]],
                   "Edges": ["sole", "right", "head", "left"]},
      "Boundary Conditions": {"right": {"Type": "Neumann", "Traction X": "-2e-3*t*y"}},
      "Rigid Motions": {"Fix": ["Rotation"]}},
    "punch": {"Material": {"Rigid": true},
      "Geometry": {"Vertices": [[-0.5, 0.6], [0.4, 0.6], [0.4, 0.8], [-0.5, 0.8]],
                   "Edges": ["tip", "right", "top", "left"]},
      "Motion": {"Displacement Y": "-0.02*min(t, 1)", "Stiffness Y": 0.5, "Rotation": 0,
                 "Displacement X": "0.01*sin(2*max(t - 1, 0))"}}},
  "Contacts": {
    "below": {"Between": ["block:sole", "base:face"], "Friction": {"Law": "Coulomb", "Coefficient": 0.3},
              "Wear": {"Coefficient": 0.1}},
    "above": {"Between": ["block:head", "punch:tip"], "Friction": {"Law": "Coulomb", "Coefficient": 0.5}}},
  "History": {"Times": [1, 1.5, 2, 2.5]},
  "Discretization": {"Mesh Size": 0.25, "Degree": 2},
  "Adaptivity": {"Maximum Levels": 1}}})scene";

struct Step {
  Vector multiplier;
  Vector forces;  ///< on the punch
  Vector works;   ///< friction's, from outside, on what wears
  double volume = 0;
};

std::vector<Step> byTheProgram(const drivers::Scene& scene) {
  std::vector<Step> steps;
  const drivers::Ranks ranks;
  drivers::PhaseTimer timer;
  const drivers::Outcome outcome =
      solveLevels(scene, ranks, timer, [&](const drivers::SolvedLevel& level) {
        for (const auto& step : level.steps) {
          const contact::Summary& punch = step->row.rigid[0].second;
          double volume = 0;
          for (const auto& [name, contact] : step->row.contacts)
            volume += contact.wornVolume;
          steps.push_back(
              {step->at.state.multiplier,
               {punch.contact.x, punch.contact.y, punch.contact.moment},
               {step->row.energyDissipated,
                step->row.energyOutside - step->row.energySprings, step->row.energyWorn},
               volume});
        }
      });
  if (outcome.status != contact::Status::Converged)
    throw bem::NumericalError(outcome.reason);
  return steps;
}

std::vector<Step> byThePackages(const drivers::Scene& scene) {
  const drivers::BodySpaces spaces(scene, firstMeshes(scene));
  const bem::Units units = scene.units();
  const double energy = scene.energy();
  std::vector<bem::Lame> lames;
  std::vector<bem::SteklovPoincare> stiffness;
  std::vector<contact::BodyInput> inputs;
  const std::vector<contact::Conditions> start = spaces.conditionsAt(0);
  for (std::size_t b = 0; b < spaces.size(); ++b)
    lames.push_back(scene.lame(b));
  for (std::size_t b = 0; b < spaces.size(); ++b)
    stiffness.push_back(contact::makeStiffness(spaces.space(b), start[b],
                                               scene.stabilization, lames[b], units));
  for (std::size_t b = 0; b < spaces.size(); ++b)
    inputs.push_back({spaces.space(b), stiffness[b], lames[b], units, start[b],
                      contact::multiplierBasis(scene.multiplier), scene.stabilization});
  const contact::ContactSystem system(inputs, scene.drivesAt(0), spaces.opposite());
  contact::PathMemory memory(system);
  contact::Prediction prediction(system);
  std::vector<Step> steps;
  for (const double t : scene.history.times) {
    const std::vector<contact::Conditions> now = spaces.conditionsAt(t);
    contact::ContactSystem step = system.under(now, scene.drivesAt(t), memory.forStep());
    const contact::Settled settled = contact::settled(
        step,
        [&](const contact::State* before) {
          return test::solve(step.numbers(),
                             before != nullptr ? *before : prediction.start(step));
        },
        bem::oneProcess());
    memory.add(step, settled.at);
    prediction.add(step, settled.at.state);
    const auto force = step.rigidForces(settled.at.state).front();
    const double unit = units.stress * units.length;
    steps.push_back(
        {settled.at.state.multiplier,
         {unit * force[0], unit * force[1], unit * units.length * force[2]},
         {energy * memory.friction(), energy * memory.outside(), energy * memory.worn()},
         units.length * units.length * memory.wornVolume()});
  }
  return steps;
}

TEUCHOS_UNIT_TEST(Embedded, aPathIsTheProgramsWithFixWearSpringsAndTwoBodies) {
  const test::TemporaryFile file("rubbing.yaml", rubbing);
  const drivers::Scene scene = drivers::readScene(file.path());
  const std::vector<Step> expected = byTheProgram(scene);
  const std::vector<Step> steps = byThePackages(scene);
  TEST_EQUALITY(steps.size(), expected.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const auto isSame = [&](const Vector& a, const Vector& b) {
      TEST_COMPARE(test::largest(b), >, 0);
      TEST_COMPARE(test::largestDifference(a, b), <=, 1e-12 * test::largest(b));
    };
    isSame(steps[k].multiplier, expected[k].multiplier);
    isSame(steps[k].forces, expected[k].forces);
    isSame(steps[k].works, expected[k].works);
    isSame({steps[k].volume}, {expected[k].volume});
  }
  TEST_COMPARE(steps.back().works[0], >, 1e-3 * steps.back().works[1]);
  TEST_COMPARE(steps.back().volume, >, 1e-6);
}

}  // namespace

}  // namespace epafi
