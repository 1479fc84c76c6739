#include "contact/system/Wear.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

using ContactElement = MultiplierSpace::ContactElement;

constexpr double closed = 1e-9;  // of the load, as in ContactFields

/// visit(element, number of the point, t, weight)
template <class Visit>
void forEachPoint(const ContactProblem& body, const Visit& visit) {
  const bem::Mesh& mesh = body.space().mesh();
  for (const ContactElement& element : body.multiplier().elements()) {
    const bem::Rule& rule = bem::gaussLegendre(element.degree + 1);
    for (int q = 0; q < rule.size(); ++q)
      visit(element, at(element.point + q), rule.points[q],
            mesh[element.element].half * rule.weights[q]);
  }
}

/// ∫ f χ_i of values at the points, one per coefficient.
Vector testedBy(const ContactProblem& body, const Vector& values) {
  Vector result(at(body.multiplier().size()), 0.0);
  forEachPoint(
      body, [&](const ContactElement& element, std::size_t k, double t, double weight) {
        const Vector chi = body.multiplier().basis().values(element.degree, t);
        for (int i = 0; i <= element.degree; ++i)
          result[at(element.normalOf(i))] += weight * values[k] * chi[at(i)];
      });
  return result;
}

/// |Δs| at the points: that of m without friction, else Σ χ_i |Δrₜ,i| / ∫ χ_i ds, at Gauss points
/// of Lagrange's polynomials there the means.  `slip`: Δrₜ, one per coefficient; empty: not known,
/// that of m.
Vector slipsOf(const ContactProblem& body, const Wear& before, const Vector& slip) {
  Vector result = body.obstacle().slid;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] -= before.slid.empty() ? 0 : before.slid[k];
  // values of a polynomial with these moments oscillate unless the basis has them
  const Vector lengths =
      slip.empty() ? Vector{} : testedBy(body, Vector(result.size(), 1.0));
  forEachPoint(body, [&](const ContactElement& element, std::size_t k, double t, double) {
    if (element.tangential >= 0 && !slip.empty()) {
      const Vector chi = body.multiplier().basis().values(element.degree, t);
      result[k] = 0;
      for (int i = 0; i <= element.degree; ++i)
        result[k] += chi[at(i)] * std::abs(slip[at(element.tangentialOf(i))]) /
                     lengths[at(element.normalOf(i))];
      result[k] = std::max(result[k], 0.0);
    }
    result[k] = element.ties() ? 0 : std::abs(result[k]);
  });
  return result;
}

}  // namespace

StepWear::StepWear(const std::vector<ContactProblem>& bodies, Numbering numbering,
                   std::vector<Wear> before)
    : bodies_(bodies),
      numbering_(std::move(numbering)),
      before_(std::move(before)),
      slips_(bodies_.size()),
      rates_(bodies_.size()) {
  for (const ContactProblem& body : bodies_)
    for (const ContactElement& element : body.multiplier().elements())
      wears_ = wears_ || element.condition->wear;
  if (wears_ && !before_.empty())
    testedBefore_ = tested(before_);
  before_.resize(bodies_.size());
}

Vector StepWear::tested(const std::vector<Wear>& wear) const {
  Vector all(numbering_.size());
  for (std::size_t b = 0; b < bodies_.size() && wears_; ++b) {
    const Vector own = testedBy(bodies_[b], wear[b].depth);
    for (std::size_t i = 0; i < own.size(); ++i)
      all[at(numbering_(b, static_cast<Index>(i)))] = own[i];
  }
  return all;
}

void StepWear::setSlips(const Vector& slip, Surface& surface) {
  surface.linear.resize(surface.linear.size() - surface.wearing);
  surface.wearing = surface.linear.size();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const ContactProblem& body = bodies_[b];
    Vector own;
    for (Index i = 0; i < numbering_.sizeOf(b) && !slip.empty(); ++i)
      own.push_back(slip[at(numbering_(b, i))]);
    slips_[b] = slipsOf(body, before_[b], own);
    rates_[b] = slips_[b];
    for (std::size_t k = 0; k < rates_[b].size(); ++k)
      rates_[b][k] *= body.obstacle().wear[k];
    if (!wears_)
      continue;
    forEachPoint(
        body, [&](const ContactElement& element, std::size_t k, double t, double weight) {
          const Vector chi = body.multiplier().basis().values(element.degree, t);
          for (int i = 0; i <= element.degree; ++i)
            for (int j = 0; j <= element.degree; ++j)
              if (const double value = weight * rates_[b][k] * chi[at(i)] * chi[at(j)];
                  value != 0)
                surface.linear.push_back({numbering_(b, element.normalOf(i)),
                                          numbering_(b, element.normalOf(j)), value});
        });
  }
  surface.wearing = surface.linear.size() - surface.wearing;
}

std::vector<Wear> StepWear::behind(const std::vector<State>& states) const {
  std::vector<Wear> wear = before_;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const ContactProblem& body = bodies_[b];
    Wear& now = wear[b];
    now.depth.resize(slips_[b].size());
    now.distance.resize(slips_[b].size());
    now.slid = body.obstacle().slid;
    now.rate = rates_[b];
    const double least = closed * body.numbers().stress;
    forEachPoint(body,
                 [&](const ContactElement& element, std::size_t k, double t, double) {
                   const double pressure =
                       body.multiplier().at(states[b].multiplier, element, t).normal;
                   now.depth[k] += rates_[b][k] * pressure;
                   if (pressure > least)
                     now.distance[k] += element.condition->cycles * slips_[b][k];
                 });
  }
  return wear;
}

}  // namespace epafi::contact
