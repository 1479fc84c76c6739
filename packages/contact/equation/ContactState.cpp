#include "contact/equation/ContactState.hpp"

#include "contact/equation/Equation.hpp"

#include <algorithm>

namespace epafi::contact {

ContactState classify(const Problem& problem, const State& state,
                      const Vector& penetration) {
  const Equation equation(problem, Equation::Bound::Lagged, 0);
  const Evaluation e = equation.at(pack(problem, state), penetration);
  ContactState result;
  for (Index i = 0; i < problem.normals; ++i)
    result.normal.push_back(e.set[at(i)] == 1 ? NormalState::Closed : NormalState::Open);
  for (std::size_t t = 0; t < e.bounds.size(); ++t) {
    const auto set = e.set[at(problem.normals) + t];
    FrictionState friction = FrictionState::Stick;
    if (e.bounds[t] <= 0)
      friction = FrictionState::None;
    else if (set != 0)
      friction = set > 0 ? FrictionState::SlipForward : FrictionState::SlipBackward;
    result.tangential.push_back(friction);
  }
  return result;
}

Vector frictionWork(const Problem& problem, const State& state,
                    const Vector& penetration) {
  const ContactState states = classify(problem, state, penetration);
  Vector work(states.tangential.size(), 0.0);
  for (std::size_t t = 0; t < work.size(); ++t) {
    const FrictionState friction = states.tangential[t];
    const std::size_t i = at(problem.normals) + t;
    if (friction == FrictionState::SlipForward || friction == FrictionState::SlipBackward)
      // rounding may leave a small negative number
      work[t] = std::max(0.0, state.multiplier[i] * penetration[i]);
  }
  return work;
}

}  // namespace epafi::contact
