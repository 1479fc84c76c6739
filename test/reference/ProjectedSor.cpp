#include "reference/ProjectedSor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace epafi::reference {

namespace {

using contact::Index;
using contact::Matrix;
using contact::Problem;
using contact::State;
using contact::Vector;

double& at(Vector& v, Index i) { return v[i]; }
double at(const Vector& v, Index i) { return v[i]; }

double boundOf(const Problem& problem, const Vector& multiplier, Index i) {
  return problem.tangentials[i - problem.normals].bound(multiplier);
}

// The penetration or slip that a uniform multiplier of size one makes at i.
double response(const Problem& problem, Index i) {
  const bool normal = i < problem.normals;
  double sum = 0;
  for (Index j = 0; j < problem.size(); ++j)
    sum += (j < problem.normals) == normal ? std::abs(problem.flexibility(i, j)) : 0.0;
  return sum;
}

// One sweep; the largest change.
double sweep(const Problem& problem, const Matrix& d, const Vector& offset, Vector& x) {
  constexpr double relaxation = 1.2;
  double change = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    double r = at(offset, i);
    for (Index j = 0; j < problem.size(); ++j)
      r -= d(i, j) * at(x, j);
    double next = at(x, i) + relaxation * r / d(i, i);
    if (i < problem.normals) {
      next = std::max(next, 0.0);
    } else {
      const double s = boundOf(problem, x, i);
      next = std::clamp(next, -s, s);
    }
    change = std::max(change, std::abs(next - at(x, i)));
    at(x, i) = next;
  }
  return change;
}

}  // namespace

State projectedSor(const Problem& problem) {
  constexpr double penalty = 10;
  Matrix d = problem.flexibility.entries().copy();
  for (Index j = 0; j < problem.rigidMotions(); ++j)
    for (Index b = 0; b < problem.size(); ++b)
      for (Index a = 0; a < problem.size(); ++a)
        d(a, b) += penalty * problem.rigid(a, j) * problem.rigid(b, j);

  State state{Vector(problem.size(), 0.0), Vector(problem.rigidLoad.size(), 0.0)};
  for (int round = 0; round < 1000000; ++round) {
    Vector offset = problem.offset;
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      for (Index i = 0; i < problem.size(); ++i)
        at(offset, i) += problem.rigid(i, j) *
                         (at(state.rigid, j) + penalty * at(problem.rigidLoad, j));
    double change = sweep(problem, d, offset, state.multiplier);
    for (Index j = 0; j < problem.rigidMotions(); ++j) {
      double rest = at(problem.rigidLoad, j);
      for (Index i = 0; i < problem.size(); ++i)
        rest -= problem.rigid(i, j) * at(state.multiplier, i);
      // Uzawa's step may be taken after each sweep when it is short.
      at(state.rigid, j) += 0.5 * penalty * rest;
      change = std::max(change, std::abs(rest));
    }
    if (change < 2e-14 * problem.stress)
      return state;
  }
  throw std::runtime_error("projected SOR does not converge");
}

double violation(const Problem& problem, const State& state) {
  const Vector closing = problem.surface.closing(state.multiplier);
  // where surfaces yield lengths count as the pressures that make them, down to rounding
  Vector yields(state.multiplier.size(), 0.0);
  for (const auto& [i, length, law] : problem.surface.places)
    at(yields, i) =
        length * law.slope(std::max(at(state.multiplier, i), 1e-12 * problem.stress));
  double worst = 0;
  const auto count = [&](double value) {
    worst = std::isfinite(value) ? std::max(worst, value) : HUGE_VAL;
  };
  for (Index i = 0; i < problem.size(); ++i) {
    double r = at(problem.offset, i) - at(closing, i);
    for (Index j = 0; j < problem.size(); ++j)
      r -= problem.flexibility(i, j) * at(state.multiplier, j);
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      r += problem.rigid(i, j) * at(state.rigid, j);
    const double y = r / (response(problem, i) + at(yields, i));
    const double x = at(state.multiplier, i);
    if (i < problem.normals) {
      count(-x);
      count(y);
      count(std::min(std::abs(x), std::abs(y)));
    } else {
      const double s = boundOf(problem, state.multiplier, i);
      if (std::isfinite(s))  // else bonded
        count(std::abs(x) - s);
      // Slip to one side needs full friction on that side.
      count(std::min(y, s - x));
      count(std::min(-y, s + x));
    }
  }
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    double rest = problem.stiffness(j) * at(state.rigid, j) - at(problem.rigidLoad, j);
    double scale = 0;
    for (Index i = 0; i < problem.size(); ++i) {
      rest += problem.rigid(i, j) * at(state.multiplier, i);
      scale += std::abs(problem.rigid(i, j));
    }
    count(std::abs(rest) / scale);
  }
  return worst;
}

}  // namespace epafi::reference
