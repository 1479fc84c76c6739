#include "contact/equation/ProblemFamily.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace epafi::contact {

ProblemFamily::ProblemFamily(const Problem& problem, Vector gap)
    : original_(problem.copy()), load_(problem.offset), gap_(std::move(gap)) {
  problem.check();
  if (static_cast<Index>(gap_.size()) != problem.normals)
    throw bem::InputError(bem::message("the contact problem has ", problem.normals,
                                       " normal coefficients, but ", gap_.size(),
                                       " gaps were given"));
  for (std::size_t i = 0; i < gap_.size(); ++i)
    load_[i] += gap_[i];
}

ProblemFamily::ProblemFamily(const Problem& problem, Vector gap, const Problem& before)
    : ProblemFamily(problem, std::move(gap)) {
  if (before.offset.size() != problem.offset.size() ||
      before.rigidLoad.size() != problem.rigidLoad.size())
    throw bem::InputError("the step before is one of another contact problem");
  const auto less = [](const Vector& a, const Vector& b) {
    Vector difference(a.size());
    std::transform(a.begin(), a.end(), b.begin(), difference.begin(), std::minus<>());
    return difference;
  };
  change_ = less(problem.offset, before.offset);
  rigidChange_ = less(problem.rigidLoad, before.rigidLoad);
}

Problem ProblemFamily::at(const Factors& factors) const {
  if (!std::isfinite(factors.load))
    throw bem::InputError(
        bem::message("load factor = ", factors.load, "; it must be finite"));
  if (!(factors.friction >= 0 && std::isfinite(factors.friction)))
    throw bem::InputError(bem::message("friction factor = ", factors.friction,
                                       "; it must be finite and not negative"));
  if (!std::isfinite(factors.increment) || (!isStep() && factors.increment != 1))
    throw bem::InputError(
        bem::message("increment = ", factors.increment,
                     "; it must be finite, and 1 without a step of a path"));
  Problem problem = original_.copy();
  for (std::size_t i = 0; i < load_.size(); ++i)
    problem.offset[i] = factors.load * load_[i] - (i < gap_.size() ? gap_[i] : 0.0);
  for (double& q : problem.rigidLoad)
    q *= factors.load;
  for (std::size_t i = 0; i < change_.size(); ++i)
    problem.offset[i] -= (1 - factors.increment) * change_[i];
  for (std::size_t i = 0; i < rigidChange_.size(); ++i)
    problem.rigidLoad[i] -= (1 - factors.increment) * rigidChange_[i];
  for (Tangential& t : problem.tangentials)
    t = t.scaled(factors.friction);
  return problem;
}

Vector ProblemFamily::derivative(const Equation& equation, const Evaluation& e,
                                 const Vector& offset, const Vector& rigidLoad) const {
  Vector result;
  result.reserve(e.residual.size());
  for (std::size_t i = 0; i < offset.size(); ++i)
    result.push_back(e.rows[i].penetration * e.weights[i] * offset[i]);
  for (std::size_t j = 0; j < rigidLoad.size(); ++j)
    result.push_back(-rigidLoad[j] / equation.balanceScales()[j]);
  return result;
}

Vector ProblemFamily::loadDerivative(const Equation& equation,
                                     const Evaluation& e) const {
  return derivative(equation, e, load_, original_.rigidLoad);
}

Vector ProblemFamily::incrementDerivative(const Equation& equation,
                                          const Evaluation& e) const {
  return derivative(equation, e, change_, rigidChange_);
}

Vector ProblemFamily::frictionDerivative(const Equation& equation,
                                         const Evaluation& e) const {
  Vector result(e.residual.size(), 0.0);
  const auto normals = static_cast<std::size_t>(original_.normals);
  const std::vector<StepBound> bounds = equation.stepBounds(e, original_.tangentials);
  for (std::size_t k = 0; k < bounds.size(); ++k)
    if (e.rows[normals + k].bound != 0)  // excludes infinite bounds
      result[normals + k] = e.rows[normals + k].bound * bounds[k].value;
  return result;
}

}  // namespace epafi::contact
