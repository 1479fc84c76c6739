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

template <class Visit>
void forEachPoint(const ContactBody& body, const Visit& visit) {
  forEachGaussPoint(body.space().mesh(), body.multiplier(), visit);
}

/// ∫ f χ_i of values at the points, one per coefficient.
Vector testedBy(const ContactBody& body, const Vector& values) {
  Vector result(at(body.multiplier().size()), 0.0);
  forEachPoint(body, [&](const SidePoint& point) {
    for (int i = 0; i <= point.contact.degree; ++i)
      result[at(point.contact.normalOf(i))] +=
          point.weight * values[point.gaussPoint()] * point.chi[at(i)];
  });
  return result;
}

/// |Δs| at the points: that of m without friction, else Σ χ_i |Δrₜ,i| / ∫ χ_i ds, at Gauss points
/// of Lagrange's polynomials there the means.  `slip`: Δrₜ, one per coefficient; empty: not known,
/// that of m.
Vector slipsOf(const ContactBody& body, const Wear& before, const Vector& slip) {
  Vector result = body.obstacle().slid;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] -= before.slid.empty() ? 0 : before.slid[k];
  // values of a polynomial with these moments oscillate unless the basis has them
  const Vector lengths =
      slip.empty() ? Vector{} : testedBy(body, Vector(result.size(), 1.0));
  forEachPoint(body, [&](const SidePoint& point) {
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

StepWear::StepWear(std::shared_ptr<const std::vector<ContactBody>> bodies,
                   Numbering numbering, std::vector<Wear> before)
    : bodies_(std::move(bodies)),
      numbering_(std::move(numbering)),
      before_(std::move(before)),
      slips_(bodies_->size()),
      rates_(bodies_->size()) {
  for (const ContactBody& body : *bodies_)
    for (const ContactElement& element : body.multiplier().elements())
      wears_ = wears_ || element.condition->wear;
  if (wears_ && !before_.empty())
    testedBefore_ = tested(before_);
  before_.resize(bodies_->size());
}

Vector StepWear::tested(const std::vector<Wear>& wear) const {
  Vector all(numbering_.size());
  for (std::size_t b = 0; b < bodies_->size() && wears_; ++b) {
    const Vector own = testedBy((*bodies_)[b], wear[b].depth);
    for (std::size_t i = 0; i < own.size(); ++i)
      all[at(numbering_(b, static_cast<Index>(i)))] = own[i];
  }
  return all;
}

void StepWear::takeSlips(const Vector& slip) {
  std::vector<Vector> next;
  std::vector<Vector> changes;
  Vector all;
  for (std::size_t b = 0; b < slips_.size(); ++b) {
    Vector own;
    for (Index i = 0; i < numbering_.sizeOf(b) && !slip.empty(); ++i)
      own.push_back(slip[at(numbering_(b, i))]);
    next.push_back(slipsOf((*bodies_)[b], before_[b], own));
    Vector change = next.back();
    slips_[b].resize(change.size());
    bem::axpy(-1, slips_[b], change);
    all.insert(all.end(), change.begin(), change.end());
    changes.push_back(std::move(change));
  }
  share_ = known_ ? aitken_.shareOf(std::move(all)) : 1;
  for (std::size_t b = 0; b < changes.size(); ++b)
    for (std::size_t k = 0; k < changes[b].size(); ++k)
      slips_[b][k] =
          std::max(known_ ? slips_[b][k] + share_ * changes[b][k] : next[b][k], 0.0);
  known_ = !slip.empty();
}

double StepWear::setSlips(const Vector& slip, Surface& surface) {
  takeSlips(slip);
  surface.linear.resize(surface.linear.size() - surface.wearing);
  surface.wearing = surface.linear.size();
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    const ContactBody& body = (*bodies_)[b];
    rates_[b] = slips_[b];
    for (std::size_t k = 0; k < rates_[b].size(); ++k)
      rates_[b][k] *= body.obstacle().wear[k];
    if (!wears_)
      continue;
    forEachPoint(body, [&](const SidePoint& point) {
      const ContactElement& element = point.contact;
      const double rate = point.weight * rates_[b][point.gaussPoint()];
      for (int i = 0; i <= element.degree; ++i)
        for (int j = 0; j <= element.degree; ++j)
          if (const double value = rate * point.chi[at(i)] * point.chi[at(j)]; value != 0)
            surface.linear.push_back({numbering_(b, element.normalOf(i)),
                                      numbering_(b, element.normalOf(j)), value});
    });
  }
  surface.wearing = surface.linear.size() - surface.wearing;
  return share_;
}

std::vector<Wear> StepWear::behind(const std::vector<State>& states) const {
  std::vector<Wear> wear = before_;
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    const ContactBody& body = (*bodies_)[b];
    Wear& now = wear[b];
    now.depth.resize(slips_[b].size());
    now.distance.resize(slips_[b].size());
    now.slid = body.obstacle().slid;
    now.rate = rates_[b];
    const double least = closed * body.stress();
    forEachPoint(body, [&](const SidePoint& point) {
      const std::size_t k = point.gaussPoint();
      const double pressure =
          body.multiplier().at(states[b].multiplier, point.contact, point.t).normal;
      now.depth[k] += rates_[b][k] * pressure;
      if (pressure > least)
        now.distance[k] += point.contact.condition->cycles * slips_[b][k];
    });
  }
  return wear;
}

}  // namespace epafi::contact
