#include "contact/newton/Descent.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/equation/SmoothMerit.hpp"
#include "contact/newton/NewtonStep.hpp"
#include "contact/newton/NewtonSystem.hpp"

#include <cmath>

namespace epafi::contact {

using bem::dot;

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

Vector meritDescentStep(const Equation& equation, const Evaluation& e,
                        FactorMemory* memory) {
  const Vector gradient = meritGradient(equation, e);
  try {
    Vector d = newtonStep(equation, e, e.linear, memory);
    const double size = std::sqrt(dot(gradient, gradient) * dot(d, d));
    if (dot(gradient, d) < -1e-10 * size)
      return d;
  } catch (const SingularJacobian&) {
    // The gradient needs no linear system.
  }
  return steepestDescent(equation, gradient);
}

}  // namespace epafi::contact
