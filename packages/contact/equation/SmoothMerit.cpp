#include "contact/equation/SmoothMerit.hpp"

namespace epafi::contact {

namespace {

Complementarity::Value smoothRow(const Problem& problem, const Evaluation& e, Index i) {
  const Complementarity& smooth = fischerBurmeister();
  const double multiplier = e.unknowns[at(i)];
  const double y = e.penetration[at(i)];
  return i < problem.normals
             ? smooth.normal(multiplier, y)
             : smooth.tangential(multiplier, y, e.bounds[at(i - problem.normals)]);
}

}  // namespace

double merit(const Equation& equation, const Evaluation& e) {
  const Problem& problem = equation.problem();
  double sum = 0;
  for (Index i = 0; i < equation.size(); ++i) {
    const double f =
        i < problem.size() ? smoothRow(problem, e, i).value : e.linear.residual[at(i)];
    sum += 0.5 * f * f;
  }
  return sum;
}

Vector meritGradient(const Equation& equation, const Evaluation& e) {
  const Problem& problem = equation.problem();
  const Index n = problem.size();
  Vector gradient(at(equation.size()), 0.0);
  Vector factors;
  for (Index i = 0; i < n; ++i) {
    const Complementarity::Value row = smoothRow(problem, e, i);
    if (i >= problem.normals)
      for (const NormalShare& slope :
           problem.tangentials[at(i - problem.normals)].slopes(e.unknowns))
        gradient[at(slope.normal)] += row.value * row.bound * slope.value;
    gradient[at(i)] += row.value * row.multiplier;
    const double factor = row.value * row.penetration * equation.weights()[at(i)];
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      gradient[at(n + j)] += factor * problem.rigid(i, j);
    factors.push_back(factor);
  }
  // the rows' part through r; D is symmetric
  const Vector throughD = problem.flexibility.times(factors);
  for (Index i = 0; i < n; ++i)
    gradient[at(i)] -= throughD[at(i)];
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    const double factor = e.linear.residual[at(n + j)] / equation.balanceScales()[at(j)];
    for (Index i = 0; i < n; ++i)
      gradient[at(i)] += factor * problem.rigid(i, j);
  }
  return gradient;
}

}  // namespace epafi::contact
