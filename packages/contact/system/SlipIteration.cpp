#include "contact/system/SlipIteration.hpp"

#include "bem/algebra/LuFactor.hpp"
#include "bem/algebra/SmallAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

constexpr int patience = 20;  // solves by Aitken's rule

double sizeOf(const Vector& x) { return std::sqrt(bem::dot(x, x)); }

}  // namespace

bool SlipIteration::wantsResponse() const { return known_ && taken_ >= patience; }

double SlipIteration::take(const Vector& next, bool isSolved, Matrix response) {
  if (!std::exchange(known_, isSolved) || slips_.empty()) {
    slips_ = next;
    taken_ = 0;
    share_ = 1;
    time_ = 0;
    return 1;
  }
  ++taken_;
  Vector change = next;
  bem::axpy(-1, slips_, change);
  const Vector step = response.rows() > 0 ? implicitStep(change, std::move(response))
                                          : bem::times(shareOf(change), change);
  const double left = bem::largestEntry(change);
  double moved = 0;
  for (std::size_t k = 0; k < slips_.size(); ++k) {
    const double before = std::exchange(slips_[k], std::max(slips_[k] + step[k], 0.0));
    moved = std::max(moved, std::abs(slips_[k] - before));
  }
  return left > 0 ? moved / left : 1;
}

double SlipIteration::shareOf(const Vector& change) {
  constexpr double least = 0.125;
  constexpr double most = 4;
  Vector turned = std::exchange(changeBefore_, change);
  if (turned.empty())
    return 1;
  const double before = bem::dot(turned, turned);
  const double mixed = bem::dot(turned, change);
  bem::axpy(-1, change, turned);
  const double square = bem::dot(turned, turned);
  share_ = square > 0 ? std::clamp(share_ * (before - mixed) / square, least, most) : 1;
  return share_;
}

Vector SlipIteration::implicitStep(const Vector& change, Matrix response) {
  constexpr double first = 0.25;
  constexpr double fastest = 2;  // τ grows in a step
  constexpr double fall = 4;
  // explicit steps nearly, along a path that ends where S has its fixed point
  const double least = taken_ < 200 ? 0.1 : 0.02;
  constexpr double rise = 1.2;  // of the bound
  const double before = sizeOf(std::exchange(changeBefore_, change));
  const double left = sizeOf(change);
  if (time_ == 0) {
    time_ = first;
    longest_ = 1e9;
  } else if (left > before) {
    longest_ = std::max(time_ / 2, least);
    time_ = std::max(time_ / fall, least);
  } else if (left > 0) {
    longest_ *= rise;
    time_ = std::min(time_ * std::min(before / left, fastest), longest_);
  }
  for (Index i = 0; i < response.rows(); ++i) {
    for (Index j = 0; j < response.columns(); ++j)
      response(i, j) *= -1;
    response(i, i) += 1 + 1 / time_;
  }
  const bem::LuFactor factor(std::move(response));
  if (!factor.isRegular())
    return bem::times(time_ / (1 + time_), change);
  Vector step = change;
  factor.solve(step);
  return step;
}

}  // namespace epafi::contact
