#include "contact/solve/Descent.hpp"

#include "contact/problem/SmallAlgebra.hpp"
#include "contact/solve/NewtonStep.hpp"
#include "contact/solve/NewtonSystem.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::contact {

namespace {

// α is a displacement and λ a stress: the gradient by α is divided by its curvature.
Vector steepestDescent(const Equation& equation, const Vector& gradient) {
  const Problem& problem = equation.problem();
  Vector d = gradient;
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    double curvature = 0;
    for (Index i = 0; i < problem.size(); ++i) {
      const double slope = equation.weights()[at(i)] * problem.rigid(i, j);
      curvature += slope * slope;
    }
    d[at(problem.size() + j)] /= curvature > 0 ? curvature : 1;
  }
  for (double& value : d)
    value = -value;
  return d;
}

}  // namespace

Vector projectOntoBox(const Problem& problem, Vector unknowns) {
  for (Index i = 0; i < problem.normals; ++i)
    unknowns[at(i)] = std::max(unknowns[at(i)], 0.0);
  const Vector bounds = problem.slipBounds(unknowns);
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    double& value = unknowns[at(problem.normals) + t];
    value = std::clamp(value, -bounds[t], bounds[t]);
  }
  return unknowns;
}

Vector projectedNewtonStep(const Equation& equation, const Evaluation& e) {
  const Problem& problem = equation.problem();
  assert(problem.rigidMotions() == 0);
  const double epsilon = problem.stress * std::min(1e-3, e.scaled);

  Evaluation split = e;
  Vector right = e.penetration;
  for (Index i = 0; i < problem.size(); ++i) {
    const double multiplier = e.unknowns[at(i)];
    const double y = e.penetration[at(i)];
    bool pushed = multiplier <= epsilon && y < 0;
    if (i >= problem.normals) {
      const double bound = e.bounds[at(i - problem.normals)];
      pushed = (multiplier >= bound - epsilon && y > 0) ||
               (multiplier <= -bound + epsilon && y < 0) || bound == 0;
    }
    split.rows[at(i)] = pushed ? Complementarity::Value{-y, 1, 0, 0}
                               : Complementarity::Value{-y, 0, -1, 0};
    if (pushed)
      right[at(i)] = 0;
  }
  // The projection cuts the pushed ones short, so the others must not reckon with them.
  Vector d = NewtonSystem(equation, split).solve(right);
  for (Index i = 0; i < problem.size(); ++i)
    if (split.rows[at(i)].penetration == 0)
      d[at(i)] = e.penetration[at(i)];
  return d;
}

Vector meritDescentStep(const Equation& equation, const Evaluation& e) {
  const Vector gradient = equation.meritGradient(e);
  try {
    Vector d = newtonStep(equation, e);
    const double size = std::sqrt(dot(gradient, gradient) * dot(d, d));
    if (dot(gradient, d) < -1e-10 * size)
      return d;
  } catch (const SingularJacobian&) {
    // The gradient needs no linear system.
  }
  return steepestDescent(equation, gradient);
}

}  // namespace epafi::contact
