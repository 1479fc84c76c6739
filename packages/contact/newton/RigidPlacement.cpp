#include "contact/newton/RigidPlacement.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/NewtonSystem.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

// Forces P(λ + y) for given penetrations y.  Bounds that depend on the pressure are taken
// as infinite, since the pressure of the solution is not known.
Vector springForces(const Problem& problem, const Vector& unknowns, const Vector& y) {
  Vector forces;
  for (Index i = 0; i < problem.normals; ++i)
    forces.push_back(std::max(unknowns[at(i)] + y[at(i)], 0.0));
  const Vector bounds = problem.slipBounds(forces);
  for (std::size_t t = 0; t < bounds.size(); ++t) {
    const std::size_t i = at(problem.normals) + t;
    const bool bonded = problem.tangentials[t].followsPressure() && bounds[t] > 0;
    const double force = unknowns[i] + y[i];
    forces.push_back(bonded ? force : std::clamp(force, -bounds[t], bounds[t]));
  }
  return forces;
}

// Rows in which closed coefficients with Coulomb friction stick.  The step then finds the
// pressure, and with it the bound.
Evaluation bonded(const Problem& problem, const Evaluation& e) {
  Evaluation rows = e;
  for (std::size_t t = 0; t < problem.tangentials.size(); ++t) {
    const Tangential& tangential = problem.tangentials[t];
    const std::size_t i = at(problem.normals) + t;
    if (!tangential.followsPressure() || !tangential.carries())
      continue;
    const bool closed =
        e.unknowns[at(tangential.normal())] + e.penetration[at(tangential.normal())] > 0;
    if (!closed)
      continue;
    rows.rows[i] = {-e.penetration[i], 0, -1, 0};
    rows.residual[i] = -e.penetration[i];
  }
  return rows;
}

// Smallest t with work(t) <= little, relative error 1e-9; work is nonincreasing.  first:
// initial t; closes: does the motion close a contact?
template <class Work>
double balance(const Work& work, double first, double little, bool closes) {
  // Largest gap: 4^20 = 1e12 times the displacements under the load.
  constexpr int quadruplings = 20;
  double low = 0;
  double high = first;
  for (int k = 0; work(high) > little; ++k) {
    if (k == quadruplings && closes)
      throw NoBalance(
          "contact, with gaps 1e12 times as large as the load's own displacements, "
          "cannot "
          "balance it: look at the units of Young's modulus, loads and gaps");
    if (k == quadruplings)
      throw NoBalance();
    low = high;
    high *= 4;
  }
  for (int i = 0; i < 100 && high - low > 1e-9 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (work(middle) > 0 ? low : high) = middle;
  }
  return high;
}

// Moves the body to α + t v where the forces P(λ + y) balance the load: at the zero of
// the work v·(q - K (α + t v) - Gᵀ P(λ + y)), which is nonincreasing in t.  λ becomes its
// projection.
Vector rigidPlacement(const Equation& equation, const Evaluation& e,
                      const Vector& motion) {
  const Problem& problem = equation.problem();
  const Index n = problem.size();
  Vector slope(at(n), 0.0);  // dy/dt
  double work0 = 0;
  double fall = 0;  // -d(work of the springs)/dt
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    const double spring = problem.stiffness(j) * motion[at(j)];
    work0 += motion[at(j)] * problem.rigidLoad[at(j)] - spring * e.unknowns[at(n + j)];
    fall += spring * motion[at(j)];
    for (Index i = 0; i < n; ++i)
      slope[at(i)] += e.weights[at(i)] * problem.rigid(i, j) * motion[at(j)];
  }
  const auto penetrationAt = [&](double t) {
    Vector y = e.penetration;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += t * slope[i];
    return y;
  };
  const auto work = [&](double t) {
    const Vector forces = springForces(problem, e.unknowns, penetrationAt(t));
    double sum = work0 - t * fall;
    for (Index i = 0; i < n; ++i)
      sum -= forces[at(i)] * slope[at(i)] / e.weights[at(i)];
    return sum;
  };

  double fastest = 0;
  double scale = std::abs(work0);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    fastest = std::max(fastest, std::abs(slope[i]));
    scale = std::max(scale, std::abs(slope[i] / e.weights[i]) * problem.stress);
  }
  // contact that the motion closes constrains it for t large enough
  const bool closes =
      std::any_of(slope.begin(), slope.begin() + problem.normals,
                  [&](double closing) { return closing > 1e-9 * fastest; });
  const double place =
      balance(work, fastest > 0 ? problem.stress / fastest : 1, 1e-12 * scale, closes);

  Vector step(e.unknowns.size());
  const Vector projection = equation.projected(e);
  for (std::size_t i = 0; i < step.size(); ++i)
    step[i] = projection[i] - e.unknowns[i];
  for (Index j = 0; j < problem.rigidMotions(); ++j)
    step[at(n + j)] = place * motion[at(j)];
  return step;
}

}  // namespace

Vector placingStep(const Equation& equation, const Evaluation& e, const Vector& motion) {
  if (equation.problem().boundDependsOnPressure()) {
    const Evaluation sticking = bonded(equation.problem(), e);
    const NewtonSystem system(equation, sticking);
    const Vector right = bem::times(-1, sticking.residual);
    if (system.unheld(right).empty()) {
      Vector step = system.solve(right);
      if (!overshoots(equation, e, step))
        return step;
    }
  }
  return rigidPlacement(equation, e, motion);
}

bool overshoots(const Equation& equation, const Evaluation& e, const Vector& step) {
  constexpr double far = 10;  // in units of the load
  const Problem& problem = equation.problem();
  for (Index i = 0; i < problem.size() && !problem.rigidStiffness.empty(); ++i) {
    double change = 0;
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      change += problem.rigid(i, j) * step[at(problem.size() + j)];
    const double now = e.unknowns[at(i)] + e.penetration[at(i)];
    const double then = now + e.weights[at(i)] * change;
    const double bound = i < problem.normals ? 0 : e.bounds[at(i - problem.normals)];
    const bool leaves = i < problem.normals
                            ? now <= 0 && then > 0
                            : bound > 0 && std::abs(now) >= bound && now * then < 0;
    if (leaves && std::abs(then) > bound + far * problem.stress)
      return true;
  }
  return false;
}

}  // namespace epafi::contact
