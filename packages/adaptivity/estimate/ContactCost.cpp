#include "adaptivity/estimate/ContactCost.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::adaptivity {

using bem::Vec2;

namespace {

double square(double x) { return x * x; }

}  // namespace

ContactCost::ContactCost(const contact::Solved& solved, const ContactElement& element,
                         const AtEnds& moments, const Contributions& factors,
                         double shearModulus)
    : moments_(moments), factors_(factors) {
  const bem::Mesh& mesh = solved.space.mesh();
  const bem::Element& geometry = mesh[element.element];
  const int p = element.degree;
  const Vec2 across = geometry.curve.normal(0);
  size_ = 2 * geometry.half / p;
  stiffness_ = shearModulus / size_;
  weight_ = 2.0 / p * of(factors_, Source::Contact);
  self_ = endValue(p, 1);
  other_ = endValue(p, -1);

  const ContactProfiles profiles = contactProfiles(solved, element, {});
  const bem::Rule& rule = bem::gaussLegendre(p + 10);
  double steepest = 0;
  // the jump of bonded sides is not the multiplier's to change
  for (std::size_t q = 0; q < rule.points.size() && !element.ties(); ++q) {
    const double t = rule.points[q];
    const double pressure = profiles.pressure(t);
    const contact::PointLaw friction = element.condition->friction.at(
        mesh.physicalPoint(element.element, t), solved.units.stress);
    points_.push_back({geometry.curve.normal(t), rule.weights[q] * geometry.half,
                       endValue(p, -t) / geometry.half, endValue(p, t) / geometry.half,
                       pressure, profiles.shear(t), profiles.opening(t),
                       profiles.tangential(t), friction, friction.followsPressure(),
                       friction.bound(pressure)});
    steepest = std::max(steepest, friction.slope(pressure));
  }
  const Vec2 along = turnLeft(across);
  directions_ = {across, along};
  if (steepest > 0) {
    directions_.push_back(across + steepest * along);
    directions_.push_back(across - steepest * along);
  }
  scale_ = (*this)({}) +
           weight_ / self_ *
               (dot(moments_.start, moments_.start) + dot(moments_.end, moments_.end));
}

AtEnds ContactCost::slope(const AtEnds& c) const {
  return {weight_ * (moments_.start + self_ * c.start + other_ * c.end),
          weight_ * (moments_.end + self_ * c.end + other_ * c.start)};
}

double ContactCost::operator()(const AtEnds& c) const {
  double sum =
      weight_ * (2 * dot(moments_.start, c.start) + 2 * dot(moments_.end, c.end) +
                 self_ * (dot(c.start, c.start) + dot(c.end, c.end)) +
                 2 * other_ * dot(c.start, c.end));
  const auto factor = [&](Source source) {
    return factors_[static_cast<std::size_t>(source)];
  };
  for (const Point& point : points_) {
    const Vec2 change = point.start * c.start + point.end * c.end;
    const double pressure = point.pressure + dot(change, point.normal);
    const double shear = point.shear + dot(change, turnLeft(point.normal));
    const double s = point.followsPressure ? point.friction.bound(pressure) : point.bound;
    const double along = std::clamp(point.slip < 0 ? -shear : shear, -s, s);
    const double gap = lostWork(positive(pressure), positive(point.opening), stiffness_);
    const double slip = lostWork(s - along, std::abs(point.slip), stiffness_);
    sum += point.weight *
           (factor(Source::Complementarity) * gap + factor(Source::Slip) * slip +
            factor(Source::Tension) * size_ * square(positive(-pressure)) +
            factor(Source::Bound) * size_ * square(positive(std::abs(shear) - s)));
  }
  return sum;
}

}  // namespace epafi::adaptivity
