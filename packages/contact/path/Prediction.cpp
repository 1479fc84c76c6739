#include "contact/path/Prediction.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

Equation sharp(const Problem& problem) {
  return Equation(problem, Equation::Bound::Differentiated, 0);
}

ContactStates statesOf(const Problem& problem, const State& state) {
  return sharp(problem).at(pack(problem, state)).states;
}

/// a - b, where b may be empty.
Vector difference(Vector a, const Vector& b) {
  if (!b.empty())
    axpy(-1, b, a);
  return a;
}

}  // namespace

Vector Prediction::loadOf(const ContactSystem& step) {
  const Problem& problem = step.numbers();
  const Equation equation = sharp(problem);
  Vector load = problem.offset;
  for (std::size_t t = 0; t < step.slipBefore().size(); ++t)
    load[at(problem.normals) + t] += step.slipBefore()[t];
  for (std::size_t i = 0; i < load.size(); ++i)
    load[i] *= equation.weights()[i];
  for (std::size_t j = 0; j < problem.rigidLoad.size(); ++j)
    load.push_back(problem.rigidLoad[j] / equation.balanceScales()[j]);
  return load;
}

void Prediction::add(const ContactSystem& step, const State& solved) {
  change_ = {difference(solved.multiplier, last_.multiplier),
             difference(solved.rigid, last_.rigid)};
  last_ = solved;
  Vector load = loadOf(step);
  loadChange_ = difference(load, load_);
  load_ = std::move(load);
  states_ = statesOf(step.numbers(), solved);
}

State Prediction::start(const ContactSystem& step) const {
  if (last_.multiplier.empty())
    return last_;
  const double size = dot(loadChange_, loadChange_);
  const double further =
      size > 0 ? dot(difference(loadOf(step), load_), loadChange_) / size : 0;
  if (!(further > 0))
    return last_;
  State ahead = last_;
  axpy(further, change_.multiplier, ahead.multiplier);
  axpy(further, change_.rigid, ahead.rigid);
  const Problem& problem = step.numbers();
  return differences(statesOf(problem, ahead), states_) <=
                 differences(statesOf(problem, last_), states_)
             ? ahead
             : last_;
}

}  // namespace epafi::contact
