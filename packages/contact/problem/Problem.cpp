#include "contact/problem/Problem.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::contact {

bool Problem::boundDependsOnPressure() const {
  return std::any_of(tangentials.begin(), tangentials.end(), [](const Tangential& t) {
    return t.law->dependsOnPressure && t.strength > 0;
  });
}

Vector Problem::slipBounds(const Vector& multiplier) const {
  Vector bounds;
  bounds.reserve(tangentials.size());
  for (const Tangential& t : tangentials) {
    const double pressure =
        multiplier.empty()
            ? 0.0
            : std::max(multiplier[static_cast<std::size_t>(t.normal)], 0.0);
    bounds.push_back(t.law->slipBound(pressure, t.strength));
  }
  return bounds;
}

Problem withSlipBounds(const Problem& problem, const Vector& bounds) {
  assert(bounds.size() == problem.tangentials.size());
  Problem fixed;
  fixed.normals = problem.normals;
  fixed.tangentials = problem.tangentials;
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    fixed.tangentials[t].law = &frictionLaw("Tresca");
    fixed.tangentials[t].strength = bounds[t];
  }
  fixed.flexibility = problem.flexibility.copy();
  fixed.offset = problem.offset;
  fixed.rigid = problem.rigid.copy();
  fixed.rigidLoad = problem.rigidLoad;
  fixed.stress = problem.stress;
  return fixed;
}

}  // namespace epafi::contact
