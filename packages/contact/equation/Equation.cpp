#include "contact/equation/Equation.hpp"

#include "bem/base/Error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

namespace epafi::contact {

namespace {

// Signed indices.
double entry(const Vector& v, Index i) { return v[at(i)]; }
double& entry(Vector& v, Index i) { return v[at(i)]; }

// c_i = 1 / Σ_j (|D_ij| + |L_ij|), D_ij of i's kind.  With 1/D_ii instead, which grows
// like 1/h², a sliding coefficient jumps to the opposite bound instead of sticking, and
// on fine meshes active sets cycle.
Vector responseWeights(const Problem& problem) {
  const Vector& responses = problem.flexibility.responses(problem.normals);
  if (!std::all_of(responses.begin(), responses.end(),
                   [](double x) { return std::isfinite(x); }))
    throw bem::NumericalError(
        "the contact flexibility holds a number that is not finite");
  const double largest =
      responses.empty() ? 0 : *std::max_element(responses.begin(), responses.end());
  Vector weights;
  weights.reserve(responses.size());
  // A coefficient that only moves the body rigidly has a zero row in D.
  for (const double response : responses)
    weights.push_back(1 / (response > 0 ? response : largest > 0 ? largest : 1));
  if (problem.surface.empty())
    return weights;
  Vector yields(weights.size(), 0.0);
  for (const auto& [row, column, value] : problem.surface.linear)
    entry(yields, row) += std::abs(value);
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] /= 1 + weights[i] * yields[i];
  return weights;
}

/// s(pressures) + s'(pressures) change.
StepBound extrapolated(const Tangential& tangential, const Vector& pressures,
                       const Vector& change) {
  StepBound bound{tangential.bound(pressures), tangential.slope(pressures)};
  if (bound.slope != 0)
    bound.value += bound.slope * entry(change, tangential.normal());
  return bound;
}

}  // namespace

Equation::Equation(const Problem& problem, Bound bound, double tolerance)
    : problem_(problem),
      bound_(bound),
      tolerance_(tolerance / problem.amplification),
      weights_(responseWeights(problem)) {
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    const double* g = problem.rigid.column(j);
    double sum = 0;
    for (Index i = 0; i < problem.size(); ++i)
      sum += std::abs(g[i]);
    balanceScales_.push_back(sum > 0 ? sum : 1);
  }
}

Evaluation Equation::at(Vector unknowns) const {
  const Index n = problem_.size();
  assert(static_cast<Index>(unknowns.size()) == size());
  Evaluation e;
  e.unknowns = std::move(unknowns);

  auto [dLambda, magnitude] =
      problem_.flexibility.product({e.unknowns.begin(), e.unknowns.begin() + n});
  Vector penetration;
  for (Index i = 0; i < n; ++i) {
    double r = entry(problem_.offset, i) - entry(dLambda, i);
    entry(magnitude, i) += std::abs(entry(problem_.offset, i));
    for (Index j = 0; j < problem_.rigidMotions(); ++j) {
      const double term = problem_.rigid(i, j) * entry(e.unknowns, n + j);
      r += term;
      entry(magnitude, i) += std::abs(term);
    }
    penetration.push_back(r);
  }
  if (!problem_.surface.empty()) {
    const Vector closing = problem_.surface.closing(
        {e.unknowns.begin(), e.unknowns.begin() + problem_.size()});
    for (Index i = 0; i < n; ++i) {
      entry(penetration, i) -= entry(closing, i);
      entry(magnitude, i) += std::abs(entry(closing, i));
    }
  }
  complete(e, std::move(penetration), std::move(magnitude));
  return e;
}

Evaluation Equation::at(Vector unknowns, const Vector& penetration) const {
  Evaluation e;
  e.unknowns = std::move(unknowns);
  complete(e, penetration, Vector(penetration.size()));
  return e;
}

void Equation::complete(Evaluation& e, Vector r, Vector magnitude) const {
  e.weights = weights_;
  e.slopes = problem_.surface.linearise(e.unknowns, r, e.weights);
  for (std::size_t i = 0; i < r.size(); ++i) {
    e.penetration.push_back(e.weights[i] * r[i]);
    magnitude[i] *= e.weights[i];
  }
  e.bounds = problem_.slipBounds(e.unknowns);
  e.stepBounds = stepBounds(e, problem_.tangentials);
  evaluateRows(e);
  measure(e, magnitude);
}

// The bound is linearised at p = λₙ + c rₙ: s(p) + s'(p) (λₙ + δλₙ - p).  After the step
// a closed coefficient has rₙ + δrₙ = 0 and the bound s(λₙ + δλₙ) to first order, an open
// one s(0).  With s(λₙ⁺), coefficients that close in this step would get zero shear, and
// on meshes graded to ends of contact the active sets would not settle.
Complementarity Equation::tangentialRow(const Evaluation& e, Index t) const {
  const double multiplier = entry(e.unknowns, problem_.normals + t);
  const double y = entry(e.penetration, problem_.normals + t);
  const double bound = e.stepBounds[static_cast<std::size_t>(t)].value;
  if (bound >= 0)
    return projectedTangential(multiplier, y, bound);
  // a negative pressure of a closed coefficient: slip in the direction of λ + c r
  const double side = multiplier + y >= 0 ? 1 : -1;
  return {multiplier - side * bound, 1, 0, -side};
}

std::vector<StepBound> Equation::stepBounds(
    const Evaluation& e, const std::vector<Tangential>& tangentials) const {
  std::vector<StepBound> result;
  result.reserve(tangentials.size());
  Vector trial;
  Vector back;
  for (Index i = 0; i < problem_.normals; ++i) {
    trial.push_back(entry(e.unknowns, i) + entry(e.penetration, i));
    back.push_back(-entry(e.penetration, i));
  }
  for (const Tangential& t : tangentials)
    if (bound_ == Bound::Lagged)
      result.push_back({t.bound(e.unknowns)});
    else
      result.push_back(extrapolated(t, trial, back));
  return result;
}

void Equation::evaluateRows(Evaluation& e) const {
  const Index n = problem_.size();
  e.rows.reserve(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    const double multiplier = entry(e.unknowns, i);
    const double y = entry(e.penetration, i);
    e.rows.push_back(i < problem_.normals ? projectedNormal(multiplier, y)
                                          : tangentialRow(e, i - problem_.normals));
    e.residual.push_back(e.rows.back().value);
  }
  for (Index j = 0; j < problem_.rigidMotions(); ++j) {
    const double* g = problem_.rigid.column(j);
    const double sum = std::inner_product(
        g, g + n, e.unknowns.begin(),
        problem_.stiffness(j) * entry(e.unknowns, n + j) - entry(problem_.rigidLoad, j));
    e.residual.push_back(sum / entry(balanceScales_, j));
  }
}

void Equation::measure(Evaluation& e, const Vector& magnitude) const {
  const double rounding = 8 * std::numeric_limits<double>::epsilon() / problem_.stress;
  double largestFloor = 0;
  e.converged = true;
  const auto count = [&](double residual, double floor) {
    const double scaled = std::abs(residual) / problem_.stress;
    largestFloor = std::max(largestFloor, floor);
    // A NaN is never converged.
    e.converged = e.converged && scaled <= std::max(tolerance_, floor);
    e.scaled = std::isnan(e.scaled) || scaled <= e.scaled ? e.scaled : scaled;
  };

  for (Index i = 0; i < problem_.size(); ++i) {
    const double multiplier = entry(e.unknowns, i);
    const double trial = multiplier + entry(e.penetration, i);
    double projection = std::max(trial, 0.0);
    double bound = 0;
    if (i < problem_.normals) {
      e.states.push_back(trial > 0 ? ContactState::Closed : ContactState::Open);
    } else {
      bound = entry(e.bounds, i - problem_.normals);
      projection = std::clamp(trial, -bound, bound);
      e.states.push_back(trial >= bound    ? ContactState::SlipForward
                         : trial <= -bound ? ContactState::SlipBackward
                                           : ContactState::Stick);
    }
    const double natural =
        projection == trial ? -entry(e.penetration, i) : multiplier - projection;
    e.natural.push_back(natural);
    const double finite = std::isfinite(bound) ? bound : 0;  // infinite: bonded
    double size = std::abs(multiplier) + finite;
    // what is clearly open or slips does so however r is rounded, as far away as it may be
    if (std::abs(trial - projection) <= rounding * problem_.stress * entry(magnitude, i))
      size += entry(magnitude, i);
    count(natural, rounding * size);
  }
  for (Index j = 0; j < problem_.rigidMotions(); ++j) {
    const double* g = problem_.rigid.column(j);
    const double spring = problem_.stiffness(j) * entry(e.unknowns, problem_.size() + j);
    const double sum = std::inner_product(
        g, g + problem_.size(), e.unknowns.begin(),
        std::abs(entry(problem_.rigidLoad, j)) + std::abs(spring), std::plus<>(),
        [](double force, double x) { return std::abs(force * x); });
    count(entry(e.residual, problem_.size() + j),
          rounding * sum / entry(balanceScales_, j));
  }
  e.tolerance = std::max(tolerance_, largestFloor);
}

Vector Equation::jacobianTimes(const Evaluation& e, const Vector& direction) const {
  const Index n = problem_.size();
  Vector dDirection =
      problem_.flexibility.times({direction.begin(), direction.begin() + n});
  addTimes(1, e.slopes, direction, dDirection);
  Vector result;
  result.reserve(direction.size());
  for (Index i = 0; i < n; ++i) {
    const auto& row = e.rows[static_cast<std::size_t>(i)];
    double r = -entry(dDirection, i);
    for (Index j = 0; j < problem_.rigidMotions(); ++j)
      r += problem_.rigid(i, j) * entry(direction, n + j);
    double value =
        row.multiplier * entry(direction, i) + row.penetration * entry(e.weights, i) * r;
    if (i >= problem_.normals) {
      const auto t = static_cast<std::size_t>(i - problem_.normals);
      if (const double slope = e.stepBounds[t].slope; slope != 0)
        value += row.bound * slope * entry(direction, problem_.tangentials[t].normal());
    }
    result.push_back(value);
  }
  for (Index j = 0; j < problem_.rigidMotions(); ++j) {
    const double* g = problem_.rigid.column(j);
    const double sum = std::inner_product(
        g, g + n, direction.begin(), problem_.stiffness(j) * entry(direction, n + j));
    result.push_back(sum / entry(balanceScales_, j));
  }
  return result;
}

// Row by row of J; D is symmetric.
Vector Equation::transposeTimes(const Evaluation& e, const Vector& v) const {
  const Index n = problem_.size();
  Vector result(v.size(), 0.0);
  Vector factors;
  for (Index i = 0; i < n; ++i) {
    const auto& row = e.rows[static_cast<std::size_t>(i)];
    entry(result, i) += row.multiplier * entry(v, i);
    if (i >= problem_.normals) {
      const auto t = static_cast<std::size_t>(i - problem_.normals);
      if (const double slope = e.stepBounds[t].slope; slope != 0)
        entry(result, problem_.tangentials[t].normal()) +=
            row.bound * slope * entry(v, i);
    }
    factors.push_back(row.penetration * entry(e.weights, i) * entry(v, i));
    for (Index j = 0; j < problem_.rigidMotions(); ++j)
      entry(result, n + j) += factors.back() * problem_.rigid(i, j);
  }
  Vector throughD = problem_.flexibility.times(factors);
  addTimes(1, e.slopes, factors, throughD);  // symmetric, too
  for (Index i = 0; i < n; ++i)
    entry(result, i) -= entry(throughD, i);
  for (Index j = 0; j < problem_.rigidMotions(); ++j) {
    const double factor = entry(v, n + j) / entry(balanceScales_, j);
    entry(result, n + j) += factor * problem_.stiffness(j);
    for (Index i = 0; i < n; ++i)
      entry(result, i) += factor * problem_.rigid(i, j);
  }
  return result;
}

Problem Equation::withTangent(const Evaluation& e) const {
  Problem result = problem_.copy();
  if (problem_.surface.places.empty())
    return result;
  result.surface = {e.slopes, {}};
  const Vector r = penetration(result, unpack(problem_, e.unknowns));
  for (std::size_t i = 0; i < r.size(); ++i)
    result.offset[i] += e.penetration[i] / e.weights[i] - r[i];
  return result;
}

Vector Equation::projected(const Evaluation& e) const {
  Vector x = e.unknowns;
  for (Index i = 0; i < problem_.normals; ++i)
    entry(x, i) = std::max(entry(x, i), 0.0);
  for (std::size_t t = 0; t < e.bounds.size(); ++t) {
    double& value = x[static_cast<std::size_t>(problem_.normals) + t];
    value = std::clamp(value, -e.bounds[t], e.bounds[t]);
  }
  return x;
}

Vector pack(const Problem& problem, const State& state) {
  Vector x(at(problem.size() + problem.rigidMotions()), 0.0);
  assert(state.multiplier.empty() ||
         static_cast<Index>(state.multiplier.size()) == problem.size());
  assert(state.rigid.empty() || state.rigid.size() == problem.rigidLoad.size());
  std::copy(state.multiplier.begin(), state.multiplier.end(), x.begin());
  std::copy(state.rigid.begin(), state.rigid.end(), x.begin() + problem.size());
  return x;
}

State unpack(const Problem& problem, const Vector& unknowns) {
  return {Vector(unknowns.begin(), unknowns.begin() + problem.size()),
          Vector(unknowns.begin() + problem.size(), unknowns.end())};
}

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
