#include "contact/system/Wear.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
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

/// |Δs| at the points: that of m without friction, else Σ χ_i |Δrₜ,i| / ∫ χ_i ds, at Gauss points
/// of Lagrange's polynomials there the means.  `slip`: Δrₜ, one per coefficient; empty: not known,
/// that of m.
Vector slipsOf(const Obstacle& obstacle, const Wear& before, const Vector& slip) {
  Vector result = obstacle.slid;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] -= before.slid.empty() ? 0 : before.slid[k];
  // values of a polynomial with these moments oscillate unless the basis has them
  const Vector lengths =
      slip.empty() ? Vector{} : testedBy(obstacle.multiplier, Vector(result.size(), 1.0));
  forEachGaussPoint(obstacle.multiplier, [&](const SidePoint& point) {
    const ContactElement& element = point.contact;
    double& own = result[point.gaussPoint()];
    if (element.shears() && !slip.empty()) {
      own = 0;
      for (int i = 0; i <= element.degree; ++i)
        own += point.chi[at(i)] * std::abs(slip[at(element.tangentialOf(i))]) /
               lengths[at(element.normalOf(i))];
      own = std::max(own, 0.0);
    }
    own = element.ties() ? 0 : std::abs(own);
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

void StepWear::takeSlips(const Vector& slip) {
  const Vector next = slipsOf(*obstacle_, before_, slip);
  Vector change = next;
  slips_.resize(change.size());
  bem::axpy(-1, slips_, change);
  share_ = known_ ? shareOf(change) : 1;
  for (std::size_t k = 0; k < change.size(); ++k)
    slips_[k] = std::max(known_ ? slips_[k] + share_ * change[k] : next[k], 0.0);
  known_ = !slip.empty();
}

double StepWear::shareOf(const Vector& change) {
  constexpr double least = 0.125;
  constexpr double most = 4;
  Vector turned = std::exchange(changeBefore_, change);
  if (turned.empty())
    return 1;
  const double before = bem::dot(turned, turned);
  const double mixed = bem::dot(turned, change);
  bem::axpy(-1, change, turned);
  const double square = bem::dot(turned, turned);
  return square > 0 ? std::clamp(share_ * (before - mixed) / square, least, most) : 1;
}

double StepWear::setSlips(const Vector& slip, Surface& surface) {
  takeSlips(slip);
  surface.linear.resize(surface.linear.size() - surface.wearing);
  surface.wearing = surface.linear.size();
  rates_ = slips_;
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
  return share_;
}

Wear StepWear::behind(const Vector& multiplier, double stress) const {
  Wear now = before_;
  now.depth.resize(slips_.size());
  now.distance.resize(slips_.size());
  now.slid = obstacle_->slid;
  now.rate = rates_;
  const double least = closed * stress;
  forEachGaussPoint(obstacle_->multiplier, [&](const SidePoint& point) {
    const std::size_t k = point.gaussPoint();
    const double pressure =
        obstacle_->multiplier.at(multiplier, point.contact, point.t).normal;
    now.depth[k] += rates_[k] * pressure;
    if (pressure > least)
      now.distance[k] += point.contact.condition->cycles * slips_[k];
  });
  return now;
}

}  // namespace epafi::contact
