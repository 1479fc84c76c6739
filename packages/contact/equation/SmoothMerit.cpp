#include "contact/equation/SmoothMerit.hpp"

#include <numeric>

namespace epafi::contact {

namespace {

/// The balance is the same.
Evaluation withSmoothRows(const Equation& equation, const Evaluation& e) {
  const Problem& problem = equation.problem();
  Evaluation result = e;
  result.rows.clear();
  result.stepBounds.clear();
  for (Index i = 0; i < problem.size(); ++i) {
    const double multiplier = e.unknowns[at(i)];
    const double y = e.penetration[at(i)];
    if (i < problem.normals) {
      result.rows.push_back(fischerNormal(multiplier, y));
    } else {
      const std::size_t t = at(i - problem.normals);
      result.rows.push_back(fischerTangential(multiplier, y, e.bounds[t]));
      result.stepBounds.push_back(
          {e.bounds[t], problem.tangentials[t].slope(e.unknowns)});
    }
    result.residual[at(i)] = result.rows.back().value;
  }
  return result;
}

}  // namespace

double merit(const Equation& equation, const Evaluation& e) {
  const Vector f = withSmoothRows(equation, e).residual;
  return 0.5 * std::inner_product(f.begin(), f.end(), f.begin(), 0.0);
}

Vector meritGradient(const Equation& equation, const Evaluation& e) {
  const Evaluation smooth = withSmoothRows(equation, e);
  return equation.transposeTimes(smooth, smooth.residual);
}

}  // namespace epafi::contact
