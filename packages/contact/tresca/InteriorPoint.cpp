#include "contact/tresca/InteriorPoint.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace epafi::contact {

using bem::axpy;
using bem::dot;

namespace {

/// Complementarity relative to the load squared: beyond it Newton's method is better.
constexpr double enough = 1e-18;
/// Share of the way to the boundary of the box.
constexpr double interior = 0.995;

/// One side of the box: slack s > 0 and dual force z > 0 of every coefficient it limits.
struct Side {
  double sign = 1;  ///< slack = sign λ + distance
  Vector slack;     ///< 0 where this side does not exist
  Vector dual;
  Vector slackChange;
  Vector dualChange;

  bool limits(std::size_t i) const { return slack[i] > 0; }

  /// Largest step that keeps slack and dual positive.
  double room() const {
    double step = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < slack.size(); ++i)
      if (limits(i)) {
        if (slackChange[i] < 0)
          step = std::min(step, -slack[i] / slackChange[i]);
        if (dualChange[i] < 0)
          step = std::min(step, -dual[i] / dualChange[i]);
      }
    return step;
  }

  void move(double step) {
    // Rounding may not carry a slack onto the boundary.
    constexpr double least = std::numeric_limits<double>::min();
    for (std::size_t i = 0; i < slack.size(); ++i)
      if (limits(i)) {
        slack[i] = std::max(slack[i] + step * slackChange[i], least);
        dual[i] = std::max(dual[i] + step * dualChange[i], least);
      }
  }
};

class Method {
 public:
  explicit Method(const Equation& equation)
      : equation_(equation), problem_(equation.problem()), n_(problem_.size()) {
    const Vector bounds = problem_.slipBounds({});
    lower_.slack = upper_.slack = Vector(at(n_), 0.0);
    unknowns_ = Vector(at(equation.size()), 0.0);
    upper_.sign = -1;
    for (Index i = 0; i < n_; ++i) {
      const bool normal = i < problem_.normals;
      const double bound = normal ? problem_.stress : bounds[at(i - problem_.normals)];
      const double distance = std::isfinite(bound) ? bound : 0;
      lower_.slack[at(i)] = distance;
      if (normal)
        unknowns_[at(i)] = distance;
      else
        upper_.slack[at(i)] = distance;
      if (bound > 0)
        free_.push_back(i);
    }
    const Evaluation e = equation.at(unknowns_);
    double force = problem_.stress;
    for (const Index i : free_)
      force += std::abs(e.penetration[at(i)]) / static_cast<double>(free_.size());
    for (Side* side : {&lower_, &upper_}) {
      side->dual = side->slackChange = side->dualChange = Vector(at(n_), 0.0);
      for (std::size_t i = 0; i < side->slack.size(); ++i)
        if (side->limits(i))
          side->dual[i] = force / equation.weights()[i];
    }
  }

  InteriorPoint run(int maximumSteps) {
    InteriorPoint result;
    while (result.iterations < maximumSteps && !free_.empty()) {
      const double mu = complementarity(0);
      if (mu < enough * problem_.stress * problem_.stress || !factorise())
        break;
      result.iterations += 1;
      direction(0);
      const double affine = complementarity(std::min(1.0, room()));
      correct();
      direction(mu * std::pow(affine / mu, 3));
      const double step = std::min(1.0, interior * room());
      if (!(step > 1e-10))
        break;
      for (std::size_t i = 0; i < unknowns_.size(); ++i)
        unknowns_[i] += step * change_[i];
      lower_.move(step);
      upper_.move(step);
      forgetCorrection();
    }
    result.unknowns = unknowns_;
    return result;
  }

 private:
  double room() const { return std::min(lower_.room(), upper_.room()); }

  /// Mean of λ's distance from a side times the force there, in stresses, after a step.
  double complementarity(double step) const {
    double sum = 0;
    double count = 0;
    for (const Side* side : {&lower_, &upper_})
      for (std::size_t i = 0; i < side->slack.size(); ++i)
        if (side->limits(i)) {
          sum += equation_.weights()[i] * (side->slack[i] + step * side->slackChange[i]) *
                 (side->dual[i] + step * side->dualChange[i]);
          count += 1;
        }
    return count > 0 ? sum / count : 0;
  }

  /// D + z/s of both sides, with the balance's own stiffness: Cholesky and the Schur
  /// complement of G.
  bool factorise() {
    stiffen(fillFactor());
    if (cholesky(factor_) != 0)
      return false;
    solvedBalance_ = balance_.copy();
    for (Index j = 0; j < balance_.columns(); ++j)
      choleskySolve(factor_, solvedBalance_.column(j));
    schur_ = transposedTimes(balance_, solvedBalance_);
    return cholesky(schur_) == 0;
  }

  /// D + z/s on what is free; returns the trace of D.
  double fillFactor() {
    const auto size = static_cast<Index>(free_.size());
    factor_ = Matrix(size, size);
    double trace = 0;
    for (Index q = 0; q < size; ++q) {
      const double* column = problem_.flexibility.column(free_[at(q)]);
      for (Index p = 0; p < size; ++p)
        factor_(p, q) = column[free_[at(p)]];
      for (const Side* side : {&lower_, &upper_})
        if (side->limits(at(free_[at(q)])))
          factor_(q, q) += side->dual[at(free_[at(q)])] / side->slack[at(free_[at(q)])];
      trace += column[free_[at(q)]];
    }
    return trace;
  }

  /// Adds each motion's G Gᵀ, of the size of D.
  void stiffen(double trace) {
    const auto size = static_cast<Index>(free_.size());
    balance_ = Matrix(size, problem_.rigidMotions());
    penalty_.clear();
    for (Index j = 0; j < balance_.columns(); ++j) {
      double square = 0;
      for (Index p = 0; p < size; ++p) {
        balance_(p, j) = problem_.rigid(free_[at(p)], j);
        square += balance_(p, j) * balance_(p, j);
      }
      penalty_.push_back(square > 0 ? trace / square : 0);
      for (Index q = 0; q < size; ++q)
        for (Index p = 0; p < size; ++p)
          factor_(p, q) += penalty_[at(j)] * balance_(p, j) * balance_(q, j);
    }
  }

  /// Newton's direction towards  slack x dual = target - correction.
  void direction(double target) {
    const Evaluation e = equation_.at(unknowns_);
    const Index motions = balance_.columns();
    Vector rest;  // q - Gᵀλ
    for (Index j = 0; j < motions; ++j)
      rest.push_back(-e.residual[at(n_ + j)] * equation_.balanceScales()[at(j)]);
    Vector right = penetrationGoal(e, target);
    for (Index j = 0; j < motions; ++j)
      axpy(penalty_[at(j)] * rest[at(j)], columnOf(balance_, j), right);
    choleskySolve(factor_, right.data());
    Vector rigid = rest;
    for (Index j = 0; j < motions; ++j)
      rigid[at(j)] -= dot(columnOf(balance_, j), right);
    choleskySolve(schur_, rigid.data());
    for (Index j = 0; j < motions; ++j)
      axpy(rigid[at(j)], columnOf(solvedBalance_, j), right);

    change_ = Vector(unknowns_.size(), 0.0);
    for (std::size_t p = 0; p < right.size(); ++p)
      change_[at(free_[p])] = right[p];
    for (Index j = 0; j < motions; ++j)
      change_[at(n_ + j)] = rigid[at(j)];
    changeSides(target);
  }

  /// What the free rows of Newton's system are to give.
  Vector penetrationGoal(const Evaluation& e, double target) const {
    Vector right;
    for (const Index i : free_) {
      double value = e.penetration[at(i)] / equation_.weights()[at(i)];
      for (const Side* side : {&lower_, &upper_})
        if (side->limits(at(i)))
          value += side->sign * goal(*side, at(i), target) / side->slack[at(i)];
      right.push_back(value);
    }
    return right;
  }

  /// What a change of the unknowns does to slacks and dual forces.
  void changeSides(double target) {
    for (Side* side : {&lower_, &upper_})
      for (const Index index : free_) {
        const std::size_t i = at(index);
        if (!side->limits(i))
          continue;
        side->slackChange[i] = side->sign * change_[i];
        side->dualChange[i] =
            (goal(*side, i, target) - side->dual[i] * side->slackChange[i]) /
                side->slack[i] -
            side->dual[i];
      }
  }

  /// What slack x dual is to become at a coefficient.
  double goal(const Side& side, std::size_t i, double target) const {
    const Vector& correction = side.sign > 0 ? lowerCorrection_ : upperCorrection_;
    return target / equation_.weights()[i] - (correction.empty() ? 0 : correction[i]);
  }

  /// Mehrotra's second order term, from the predictor.
  void correct() {
    const auto product = [](const Side& side) {
      Vector result(side.slack.size());
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = side.slackChange[i] * side.dualChange[i];
      return result;
    };
    lowerCorrection_ = product(lower_);
    upperCorrection_ = product(upper_);
  }
  void forgetCorrection() {
    lowerCorrection_.clear();
    upperCorrection_.clear();
  }

  const Equation& equation_;
  const Problem& problem_;
  Index n_;
  std::vector<Index> free_;  // coefficients with a box of positive width
  Side lower_;
  Side upper_;
  Vector unknowns_;
  Vector change_;
  Vector lowerCorrection_;
  Vector upperCorrection_;
  Matrix factor_;
  Matrix balance_;
  Matrix solvedBalance_;
  Matrix schur_;
  Vector penalty_;
};

}  // namespace

InteriorPoint interiorPoint(const Equation& equation, int maximumSteps) {
  assert(!equation.problem().boundDependsOnPressure());
  return Method(equation).run(maximumSteps);
}

}  // namespace epafi::contact
