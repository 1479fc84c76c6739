#include "contact/equation/ProblemFamily.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cmath>

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

Problem ProblemFamily::at(const Factors& factors) const {
  if (!std::isfinite(factors.load))
    throw bem::InputError(
        bem::message("load factor = ", factors.load, "; it must be finite"));
  if (!(factors.friction >= 0 && std::isfinite(factors.friction)))
    throw bem::InputError(bem::message("friction factor = ", factors.friction,
                                       "; it must be finite and not negative"));
  Problem problem = original_.copy();
  for (std::size_t i = 0; i < load_.size(); ++i)
    problem.offset[i] = factors.load * load_[i] - (i < gap_.size() ? gap_[i] : 0.0);
  for (double& q : problem.rigidLoad)
    q *= factors.load;
  for (Tangential& t : problem.tangentials)
    t = t.scaled(factors.friction);
  return problem;
}

Vector ProblemFamily::loadDerivative(const Equation& equation,
                                     const Evaluation& e) const {
  Vector result;
  result.reserve(e.residual.size());
  for (std::size_t i = 0; i < load_.size(); ++i)
    result.push_back(e.rows[i].penetration * equation.weights()[i] * load_[i]);
  for (std::size_t j = 0; j < original_.rigidLoad.size(); ++j)
    result.push_back(-original_.rigidLoad[j] / equation.balanceScales()[j]);
  return result;
}

Vector ProblemFamily::frictionDerivative(const Equation& equation,
                                         const Evaluation& e) const {
  Vector result(e.residual.size(), 0.0);
  const auto normals = static_cast<std::size_t>(original_.normals);
  const std::vector<StepBound> bounds = equation.stepBounds(e, original_.tangentials);
  for (std::size_t k = 0; k < bounds.size(); ++k)
    if (e.rows[normals + k].bound != 0)  // a bound may be infinite
      result[normals + k] = e.rows[normals + k].bound * bounds[k].value;
  return result;
}

}  // namespace epafi::contact
