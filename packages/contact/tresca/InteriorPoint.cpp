#include "contact/tresca/InteriorPoint.hpp"

#include "contact/newton/NewtonSystem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::contact {

namespace {

/// Complementarity relative to the load squared: less is rounding.
constexpr double enough = 1e-30;
/// Share of the way to the boundary of the set; all of it as complementarity vanishes, since
/// a fixed share would end Newton's quadratic convergence.
constexpr double interior = 0.995;
/// So many steps that are so short, one after the other, lead nowhere.
constexpr double shortStep = 0.03;
constexpr int mostJams = 3;
/// Below this so many steps without half of the complementarity are rounding.
constexpr double small = 1e-12;
constexpr int mostStale = 8;

/// side λ_i + s_i >= 0, s_i the slip bound, zero for a pressure: the distance a > 0 from
/// there and the force z > 0 that keeps it.
struct Limit {
  Index coefficient;
  double side;
  double distance;
  double force = 0;
  double distanceChange = 0;
  double forceChange = 0;
  double correction = 0;  ///< Mehrotra's second order term, weighted

  double product(double step) const {
    return (distance + step * distanceChange) * (force + step * forceChange);
  }
  double stiffness() const { return force / distance; }
};

class Method {
 public:
  Method(const Equation& equation, SecondOrder order)
      : equation_(equation), problem_(equation.problem()), order_(order) {
    Vector unknowns(at(equation.size()), 0.0);
    std::fill_n(unknowns.begin(), problem_.normals, problem_.stress);
    move(std::move(unknowns));
    for (Index i = 0; i < problem_.size(); ++i) {
      if (i < problem_.normals) {
        limits_.push_back({i, 1, problem_.stress});
      } else if (tangential(i).carries() && !tangential(i).isTied()) {
        const double bound = e_.bounds[at(i - problem_.normals)];
        for (const double side : {1.0, -1.0})
          limits_.push_back({i, side, bound > 0 ? bound : problem_.stress});
      }
    }
    double force = 0;
    for (const Limit& limit : limits_)
      force += std::abs(e_.penetration[at(limit.coefficient)]);
    force = problem_.stress + force / static_cast<double>(limits_.size());
    for (Limit& limit : limits_)
      limit.force = force / weight(limit);
  }

  InteriorPoint run(int maximumSteps) {
    InteriorPoint result;
    try {
      start();
      while (result.iterations < maximumSteps && !e_.converged && advance())
        result.iterations += 1;
    } catch (const SingularJacobian&) {
      // as far as it went
    }
    result.unknowns = e_.unknowns;
    result.jammed = jams_ == mostJams;
    return result;
  }

 private:
  const Tangential& tangential(Index i) const {
    return problem_.tangentials[at(i - problem_.normals)];
  }
  double weight(const Limit& limit) const {
    return equation_.weights()[at(limit.coefficient)];
  }

  void move(Vector unknowns) {
    e_ = equation_.at(std::move(unknowns));
    rows_ = e_.linear;
    for (std::size_t t = 0; t < e_.bounds.size(); ++t)
      rows_.stepBounds[t] = {e_.bounds[t], problem_.tangentials[t].slopes(e_.unknowns)};
  }

  /// Where all of the predictor's step leads, with distances and forces not below their means:
  /// of the size of the solution, which the load need not be (a small contact under a large
  /// body).                                                           [Gertz, Wright 2003]
  void start() {
    setRows();
    const Vector change = direction(NewtonSystem(equation_, rows_), 0);
    Vector unknowns = e_.unknowns;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      unknowns[i] += change[i];
    double distance = 0;
    double force = 0;
    for (Limit& limit : limits_) {
      limit.distance = std::abs(limit.distance + limit.distanceChange);
      limit.force = std::abs(limit.force + limit.forceChange);
      distance += limit.distance / static_cast<double>(limits_.size());
      force += weight(limit) * limit.force / static_cast<double>(limits_.size());
    }
    for (Limit& limit : limits_) {
      limit.distance = std::max(limit.distance, distance);
      limit.force = std::max(limit.force, force / weight(limit));
    }
    move(std::move(unknowns));
  }

  /// Predictor and corrector.
  bool advance() {
    const double mu = complementarity(0);
    if (!(mu > enough * problem_.stress * problem_.stress))
      return false;
    setRows();
    const NewtonSystem system(equation_, rows_);
    for (Limit& limit : limits_)
      limit.correction = 0;
    direction(system, 0);
    const double reach = std::min(1.0, room());
    const double affine = complementarity(reach);
    const double share = order_ == SecondOrder::ByReach ? reach : 1;
    for (Limit& limit : limits_)
      limit.correction = share * limit.distanceChange * limit.forceChange;
    const Vector change = direction(system, mu * std::pow(affine / mu, 3));
    const double relative = mu / (problem_.stress * problem_.stress);
    const double step = std::min(1.0, std::max(interior, 1 - relative) * room());
    jams_ = step < shortStep ? jams_ + 1 : 0;
    stale_ = least_ < small && relative > 0.5 * least_ ? stale_ + 1 : 0;
    least_ = std::min(relative, least_);
    if (jams_ == mostJams || stale_ == mostStale)
      return false;
    Vector unknowns = e_.unknowns;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      unknowns[i] += step * change[i];
    // Rounding may not carry anything onto the boundary.
    constexpr double least = std::numeric_limits<double>::min();
    for (Limit& limit : limits_) {
      limit.distance = std::max(limit.distance + step * limit.distanceChange, least);
      limit.force = std::max(limit.force + step * limit.forceChange, least);
    }
    move(std::move(unknowns));
    return true;
  }

  /// Mean of distance times force, in stresses, after a step.
  double complementarity(double step) const {
    double sum = 0;
    for (const Limit& limit : limits_)
      sum += weight(limit) * limit.product(step);
    return sum / static_cast<double>(limits_.size());
  }

  /// Largest step that keeps all distances and forces positive.
  double room() const {
    double step = std::numeric_limits<double>::max();
    for (const Limit& limit : limits_) {
      if (limit.distanceChange < 0)
        step = std::min(step, -limit.distance / limit.distanceChange);
      if (limit.forceChange < 0)
        step = std::min(step, -limit.force / limit.forceChange);
    }
    return step;
  }

  /// The rows  r + Σ side z = 0  with z's change eliminated:
  ///   c (D dλ - G dα + Σ z/a (dλ_i + side ds_i)) = ...,  over 1 + c Σ z/a.
  void setRows() {
    for (Complementarity::Value& row : rows_.rows)
      row = {0, 0, -1, 0};
    for (const Limit& limit : limits_) {
      Complementarity::Value& row = rows_.rows[at(limit.coefficient)];
      row.multiplier += weight(limit) * limit.stiffness();
      row.bound += limit.side * weight(limit) * limit.stiffness();
    }
    for (Index i = 0; i < problem_.size(); ++i) {
      Complementarity::Value& row = rows_.rows[at(i)];
      if (i >= problem_.normals && !tangential(i).carries())
        row = {0, 1, 0, 0};
      const double size = 1 + (row.penetration == 0 ? 0 : row.multiplier);
      row = {0, row.multiplier / size, row.penetration / size, row.bound / size};
    }
  }

  /// Newton's direction towards  distance x force = target - correction.
  Vector direction(const NewtonSystem& system, double target) {
    Vector right;
    for (std::size_t i = 0; i < e_.unknowns.size(); ++i)
      right.push_back(i < rows_.rows.size()
                          ? -rows_.rows[i].penetration * e_.penetration[i]
                          : -e_.linear.residual[i]);
    for (const Limit& limit : limits_) {
      const std::size_t i = at(limit.coefficient);
      right[i] -= rows_.rows[i].penetration * weight(limit) * limit.side *
                  (goal(limit, target) - limit.force * gap(limit)) / limit.distance;
    }
    Vector change = system.solve(right);
    for (Limit& limit : limits_) {
      limit.distanceChange = gap(limit) + limit.side * change[at(limit.coefficient)] +
                             boundChange(limit, change);
      limit.forceChange =
          (goal(limit, target) - limit.force * limit.distanceChange) / limit.distance -
          limit.force;
    }
    return change;
  }

  /// What distance x force is to become.
  double goal(const Limit& limit, double target) const {
    return target / weight(limit) - limit.correction;
  }

  /// By how much side λ_i + s_i is more than the distance.
  double gap(const Limit& limit) const {
    const Index t = limit.coefficient - problem_.normals;
    return limit.side * e_.unknowns[at(limit.coefficient)] +
           (t < 0 ? 0 : e_.bounds[at(t)]) - limit.distance;
  }

  double boundChange(const Limit& limit, const Vector& change) const {
    const Index t = limit.coefficient - problem_.normals;
    double sum = 0;
    if (t >= 0)
      for (const NormalShare& slope : rows_.stepBounds[at(t)].slopes)
        sum += slope.value * change[at(slope.normal)];
    return sum;
  }

  const Equation& equation_;
  const Problem& problem_;
  SecondOrder order_;
  std::vector<Limit> limits_;
  Evaluation e_;
  LinearRows rows_;  // of the limits
  int jams_ = 0;
  int stale_ = 0;
  double least_ = std::numeric_limits<double>::infinity();  // complementarity
};

}  // namespace

InteriorPoint interiorPoint(const Equation& equation, SecondOrder order,
                            int maximumSteps) {
  return Method(equation, order).run(maximumSteps);
}

}  // namespace epafi::contact
