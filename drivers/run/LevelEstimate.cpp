#include "drivers/run/LevelEstimate.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

/// Indicators of one body in each state; of a half cut by symmetry as of the whole.
std::vector<adaptivity::Indicators> indicatorsOf(
    const Ground& ground, const std::vector<const SolvedBodies*>& states, std::size_t b) {
  std::vector<adaptivity::Estimated> ofBody;
  ofBody.reserve(states.size());
  for (const SolvedBodies* solved : states)
    ofBody.push_back({solved->bodies()[b], solved->densities()[b]});
  std::vector<adaptivity::Indicators> all = adaptivity::estimateResiduals(
      ofBody, ground.lames[b], ground.scene.adaptivity.estimator, ground.processes);
  for (adaptivity::Indicators& one : all)
    for (adaptivity::Contributions& squares : one.squares)
      for (double& square : squares)
        square *= ground.scene.symmetry.copies();
  return all;
}

/// Squared energy norms below which rounding has all digits: those of a motion without strain.
double roundingOf(const Scene& scene, const SolvedBodies& solved) {
  double motion = 0;
  for (const bem::Vector& displacement : solved.placement().displacements)
    for (const double u : displacement)
      motion = std::max(motion, std::abs(u));
  return 1e-24 * scene.energy() * motion * motion;
}

/// See Level::relativeEstimate.
double relative(const Scene& scene, const std::vector<const SolvedBodies*>& states,
                const bem::Vector& estimates, const bem::Vector& strainEnergies) {
  const double largest = *std::max_element(strainEnergies.begin(), strainEnergies.end());
  double result = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    const double square = estimates[k] * estimates[k];
    // rounding may leave an energy below zero
    const double norm = 2 * std::max({strainEnergies[k], largest / 100, 0.0});
    if (std::max(square, norm) > roundingOf(scene, *states[k]))
      result = std::max(result, estimates[k] / std::sqrt(norm));
  }
  return result;
}

}  // namespace

bem::Vector estimateErrors(const Ground& ground,
                           const std::vector<const SolvedBodies*>& states,
                           const bem::Vector& strainEnergies, Level& level) {
  bem::Vector estimates(states.size(), 0.0);
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const std::vector<adaptivity::Indicators> all = indicatorsOf(ground, states, b);
    for (std::size_t k = 0; k < all.size(); ++k)
      estimates[k] = std::hypot(estimates[k], all[k].estimate());
    level.bodies[b].indicators = adaptivity::largest(all);
  }
  level.relativeEstimate =
      ground.processes
          .broadcast({relative(ground.scene, states, estimates, strainEnergies)})
          .front();
  return estimates;
}

}  // namespace epafi::drivers
