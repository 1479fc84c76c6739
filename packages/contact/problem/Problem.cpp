#include "contact/problem/Problem.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::contact {

bool Problem::boundDependsOnPressure() const {
  return std::any_of(tangentials.begin(), tangentials.end(), [](const Tangential& t) {
    return t.law->dependsOnPressure && t.largestStrength() > 0;
  });
}

bool Problem::boundsAreCoupled() const {
  return std::any_of(tangentials.begin(), tangentials.end(),
                     [](const Tangential& t) { return !t.others.empty(); });
}

Vector Problem::slipBounds(const Vector& multiplier) const {
  Vector bounds;
  bounds.reserve(tangentials.size());
  const Vector zero(multiplier.empty() ? static_cast<std::size_t>(normals) : 0, 0.0);
  for (const Tangential& t : tangentials)
    bounds.push_back(t.bound(multiplier.empty() ? zero : multiplier));
  return bounds;
}

Problem withUncoupledBounds(const Problem& problem) {
  Problem result = withSlipBounds(problem, problem.slipBounds({}));
  std::transform(problem.tangentials.begin(), problem.tangentials.end(),
                 result.tangentials.begin(),
                 [](const Tangential& t) { return t.uncoupled(); });
  return result;
}

Problem withSlipBounds(const Problem& problem, const Vector& bounds) {
  assert(bounds.size() == problem.tangentials.size());
  Problem fixed;
  fixed.normals = problem.normals;
  for (std::size_t t = 0; t < bounds.size(); ++t)
    fixed.tangentials.push_back(
        {problem.tangentials[t].normal, &frictionLaw("Tresca"), bounds[t]});
  fixed.flexibility = problem.flexibility.copy();
  fixed.offset = problem.offset;
  fixed.rigid = problem.rigid.copy();
  fixed.rigidLoad = problem.rigidLoad;
  fixed.stress = problem.stress;
  return fixed;
}

}  // namespace epafi::contact
