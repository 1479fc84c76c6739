#include "contact/system/Wear.hpp"

#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

using ContactElement = MultiplierSpace::ContactElement;

constexpr double closed = 1e-9;  // of the load, as in ContactFields

/// ∫ f χ_i of values at the points, one per coefficient.
Vector testedBy(const MultiplierSpace& multiplier, const Vector& values) {
  Vector result(at(multiplier.size()), 0.0);
  forEachGaussPoint(multiplier, [&](const SidePoint& point) {
    for (int i = 0; i <= point.contact.degree; ++i)
      result[at(point.contact.normalOf(i))] +=
          point.weight * values[point.gaussPoint()] * point.chi[at(i)];
  });
  return result;
}

/// Σ χ_i x_i / ∫ χ_i ds at the points of what shears, of tangential coefficients: at Gauss points of
/// Lagrange's polynomials means.  (Values of a polynomial with these moments oscillate unless the basis
/// has them.)  `values`: what is elsewhere
Vector atPointsOf(const MultiplierSpace& multiplier, const Vector& x, Vector values) {
  const Vector lengths = testedBy(multiplier, Vector(values.size(), 1.0));
  forEachGaussPoint(multiplier, [&](const SidePoint& point) {
    const ContactElement& element = point.contact;
    if (!element.shears())
      return;
    double& own = values[point.gaussPoint()];
    own = 0;
    for (int i = 0; i <= element.degree; ++i)
      own += point.chi[at(i)] * x[at(element.tangentialOf(i))] /
             lengths[at(element.normalOf(i))];
  });
  return values;
}

/// |Δs| at the points: that of m without friction, else by the slips.  `slip`: Δrₜ, one per
/// coefficient; empty: not known, that of m.
Vector slipsOf(const Obstacle& obstacle, const Wear& before, Vector slip) {
  Vector result = obstacle.slid;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = std::abs(result[k] - (before.slid.empty() ? 0 : before.slid[k]));
  for (double& x : slip)
    x = std::abs(x);
  if (!slip.empty())
    result = atPointsOf(obstacle.multiplier, slip, std::move(result));
  forEachGaussPoint(obstacle.multiplier, [&](const SidePoint& point) {
    double& own = result[point.gaussPoint()];
    own = point.contact.ties() ? 0 : std::max(own, 0.0);
  });
  return result;
}

}  // namespace

StepWear::StepWear(std::shared_ptr<const Obstacle> obstacle, Wear before)
    : obstacle_(std::move(obstacle)), before_(std::move(before)) {
  obstacle_->multiplier.forEachElement(
      [&](const ContactElement& element) { wears_ = wears_ || element.condition->wear; });
  if (wears_ && !before_.depth.empty())
    testedBefore_ = tested(before_);
}

Vector StepWear::tested(const Wear& wear) const {
  return wears_ ? testedBy(obstacle_->multiplier, wear.depth)
                : Vector(at(obstacle_->multiplier.size()));
}

Matrix StepWear::wornBy(const Vector& multiplier) const {
  Matrix result(obstacle_->multiplier.size(), static_cast<Index>(rates_.size()));
  forEachGaussPoint(obstacle_->multiplier, [&](const SidePoint& point) {
    const std::size_t k = point.gaussPoint();
    const double pressure =
        obstacle_->multiplier.at(multiplier, point.contact, point.t).normal;
    for (int i = 0; i <= point.contact.degree; ++i)
      result(point.contact.normalOf(i), static_cast<Index>(k)) =
          point.weight * obstacle_->wear[k] * pressure * point.chi[at(i)];
  });
  return result;
}

Vector StepWear::atPoints(const Vector& changes) const {
  return atPointsOf(obstacle_->multiplier, changes, Vector(rates_.size()));
}

double StepWear::setSlips(const Vector& slip, Surface& surface, Matrix response) {
  const double share =
      slips_.take(slipsOf(*obstacle_, before_, slip), !slip.empty(), std::move(response));
  surface.linear.resize(surface.linear.size() - surface.wearing);
  surface.wearing = surface.linear.size();
  rates_ = slips_.slips();
  for (std::size_t k = 0; k < rates_.size(); ++k)
    rates_[k] *= obstacle_->wear[k];
  if (wears_)
    forEachGaussPoint(obstacle_->multiplier, [&](const SidePoint& point) {
      const ContactElement& element = point.contact;
      const double rate = point.weight * rates_[point.gaussPoint()];
      for (int i = 0; i <= element.degree; ++i)
        for (int j = 0; j <= element.degree; ++j)
          if (const double value = rate * point.chi[at(i)] * point.chi[at(j)]; value != 0)
            surface.linear.push_back({element.normalOf(i), element.normalOf(j), value});
    });
  surface.wearing = surface.linear.size() - surface.wearing;
  return share;
}

Wear StepWear::behind(const Vector& multiplier, double stress) const {
  Wear now = before_;
  now.depth.resize(rates_.size());
  now.distance.resize(rates_.size());
  now.slid = obstacle_->slid;
  now.rate = rates_;
  const double least = closed * stress;
  forEachGaussPoint(obstacle_->multiplier, [&](const SidePoint& point) {
    const std::size_t k = point.gaussPoint();
    const double pressure =
        obstacle_->multiplier.at(multiplier, point.contact, point.t).normal;
    now.depth[k] += rates_[k] * pressure;
    if (pressure > least)
      now.distance[k] += point.contact.condition->cycles * slips_.slips()[k];
  });
  return now;
}

}  // namespace epafi::contact
