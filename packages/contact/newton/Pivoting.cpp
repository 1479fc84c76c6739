#include "contact/newton/Pivoting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

constexpr double shareOfLargest = 0.5;
constexpr double solved = 1e-6;  // of the load: what a step leaves of its own problem

// s(λₙ) and its slopes as the sets of normal coefficients have them: linear beyond λₙ = 0
// where one is closed, nothing where it is open.
std::vector<StepBound> boundsHeld(const Problem& problem, const Evaluation& e,
                                  const ActiveSet& set) {
  constexpr double least = std::numeric_limits<double>::min();
  Vector pressures;
  Vector beyond;
  for (Index i = 0; i < problem.normals; ++i) {
    const double pressure = e.unknowns[at(i)];
    const bool closed = set[at(i)] != 0;
    pressures.push_back(closed ? std::max(pressure, least) : 0.0);
    beyond.push_back(closed ? pressure - pressures.back() : 0.0);
  }
  std::vector<StepBound> bounds;
  bounds.reserve(problem.tangentials.size());
  for (const Tangential& t : problem.tangentials)
    bounds.push_back(extrapolated(t, pressures, beyond));
  return bounds;
}

std::vector<std::size_t> differences(const ActiveSet& a, const ActiveSet& b) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i])
      result.push_back(i);
  return result;
}

// How much stress a coefficient asks for: what it is beyond its bound, or r_i / D_ii,
// what closes its gap alone.
double violation(const Equation& equation, const Evaluation& e, std::size_t i) {
  const double natural = std::abs(e.natural[i]);
  const double flexibility = equation.problem().flexibility.diagonal()[i];
  const bool byGap = natural == std::abs(e.penetration[i]) && flexibility > 0;
  return byGap ? natural / (equation.weights()[i] * flexibility) : natural;
}

bool solvesItsProblem(const Equation& equation, const Evaluation& e,
                      const ActiveSet& set) {
  const Vector left = holding(equation, e, set).residual;
  return std::all_of(left.begin(), left.end(), [&](double f) {
    return std::abs(f) <= solved * equation.problem().stress;
  });
}

}  // namespace

ActiveSet rowSet(const Evaluation& e) {
  const std::size_t normals = e.linear.rows.size() - e.bounds.size();
  ActiveSet set;
  for (std::size_t i = 0; i < e.linear.rows.size(); ++i) {
    const Complementarity::Value& row = e.linear.rows[i];
    const bool open = row.penetration == 0;
    if (i < normals)
      set.push_back(open ? 0 : 1);
    else
      set.push_back(static_cast<signed char>(!open ? 0 : row.bound < 0 ? 1 : -1));
  }
  return set;
}

LinearRows holding(const Equation& equation, const Evaluation& e, const ActiveSet& set) {
  const Problem& problem = equation.problem();
  LinearRows held = e.linear;
  held.stepBounds = boundsHeld(problem, e, set);
  for (Index i = 0; i < problem.size(); ++i) {
    const double multiplier = e.unknowns[at(i)];
    Complementarity::Value& row = held.rows[at(i)];
    const bool tangential = i >= problem.normals;
    if (tangential) {
      const double side = set[at(i)];
      row = {multiplier - side * held.stepBounds[at(i - problem.normals)].value, 1, 0,
             -side};
    } else {
      row = {multiplier, 1, 0, 0};
    }
    if (tangential == (set[at(i)] == 0))
      row = {-e.penetration[at(i)], 0, -1, 0};
    held.residual[at(i)] = row.value;
  }
  return held;
}

ActiveSet Pivoting::next(const Equation& equation, const Evaluation& e) {
  const ActiveSet wanted = rowSet(e);
  if (set_.empty() || !solvesItsProblem(equation, e, set_))
    begin(wanted);
  else
    choose(equation, e, wanted);
  return set_;
}

void Pivoting::begin(ActiveSet set) {
  set_ = std::move(set);
  fewest_ = std::numeric_limits<std::size_t>::max();
  seen_.clear();
  single_ = false;
}

void Pivoting::choose(const Equation& equation, const Evaluation& e,
                      const ActiveSet& wanted) {
  const std::vector<std::size_t> violated = differences(set_, wanted);
  if (violated.empty() && fewest_ == 0)
    return;  // the right set, and only rounding is left to reduce
  if (violated.size() < fewest_) {
    begin(wanted);
    fewest_ = violated.size();
    seen_.insert(set_);
    return;
  }
  ActiveSet some = set_;
  double largest = 0;
  for (const std::size_t i : violated)
    largest = std::max(largest, violation(equation, e, i));
  for (const std::size_t i : violated)
    if (violation(equation, e, i) >= shareOfLargest * largest)
      some[i] = wanted[i];
  single_ = single_ || seen_.count(some) > 0;
  if (single_) {
    set_[violated.back()] = wanted[violated.back()];
  } else {
    set_ = std::move(some);
    seen_.insert(set_);
  }
}

}  // namespace epafi::contact
