#include "contact/equation/ContactState.hpp"

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

ContactState classify(const Problem& problem, const State& state) {
  const Equation equation(problem, projection(), Equation::Bound::Lagged, 0);
  const Evaluation e = equation.at(pack(problem, state));
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

}  // namespace epafi::contact
