#pragma once

#include "contact/RandomProblem.hpp"
#include "contact/nox/ContactModel.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace epafi::test {

struct ModelSample {
  contact::Problem problem;
  contact::Vector gap;
};

/// A problem of a load of the given size, with gaps.
inline ModelSample modelSample(const char* law, contact::Index rigidMotions,
                               double stress, std::mt19937& random) {
  Recipe recipe = Recipe::of(law, 0.4, rigidMotions);
  recipe.normals = 12;
  recipe.softness = 1;
  ModelSample result{randomProblem(recipe, random), {}};
  contact::Problem& problem = result.problem;
  for (contact::Index i = 0; i < problem.normals; ++i)
    result.gap.push_back(0.1 * std::sqrt(problem.flexibility(i, i)) *
                         std::uniform_real_distribution<double>(0, 1)(random));
  const auto scale = [&](double& value) { value *= stress; };
  std::for_each(problem.offset.begin(), problem.offset.end(), scale);
  std::for_each(problem.rigidLoad.begin(), problem.rigidLoad.end(), scale);
  std::for_each(result.gap.begin(), result.gap.end(), scale);
  for (contact::Tangential& t : problem.tangentials)
    if (!t.followsPressure())
      t = t.scaled(stress);
  problem.stress = stress;
  return result;
}

}  // namespace epafi::test
