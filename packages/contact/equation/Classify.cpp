#include "contact/equation/Classify.hpp"

#include "contact/equation/Equation.hpp"

#include <algorithm>

namespace epafi::contact {

ContactStates classify(const Problem& problem, const State& state,
                       const Vector& penetration) {
  const Equation equation(problem, Equation::Bound::Lagged, 0);
  Evaluation e = equation.at(pack(problem, state), penetration);
  for (std::size_t t = 0; t < e.bounds.size(); ++t)
    if (e.bounds[t] <= 0)
      e.states[at(problem.normals) + t] = ContactState::Frictionless;
  return std::move(e.states);
}

Vector frictionWork(const Problem& problem, const State& state,
                    const Vector& penetration) {
  const ContactStates states = classify(problem, state, penetration);
  Vector work(problem.tangentials.size(), 0.0);
  for (std::size_t t = 0; t < work.size(); ++t)
    if (const std::size_t i = at(problem.normals) + t; slips(states[i]))
      // rounding may leave a small negative number
      work[t] = std::max(0.0, state.multiplier[i] * penetration[i]);
  return work;
}

}  // namespace epafi::contact
