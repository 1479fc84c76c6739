#include "adaptivity/estimate/ContactCost.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::adaptivity {

using bem::Pack;
using bem::Vec2;

namespace {

EPAFI_INLINE Pack& positivePart(Pack& x) { return x = x > 0.0 ? x : Pack{}; }

/// lostWork for one stiffness, at eight points.
EPAFI_INLINE void addLostWork(const Pack& force, const Pack& length, double stiffness,
                              double factor, Pack& sum) {
  const Pack back = stiffness * length;
  const Pack workingForce = (4.0 * force - 2.0 * back) * (1.0 / 3);
  const Pack workingBack = (4.0 * back - 2.0 * force) * (1.0 / 3);
  const Pack both = workingForce * workingBack +
                    0.25 * (workingForce * workingForce + workingBack * workingBack);
  const Pack work = 2.0 * back <= force   ? back * back
                    : 2.0 * force <= back ? force * force
                                          : both;
  sum += (factor / stiffness) * work;
}

}  // namespace

/// The sum over the points of all terms that a correction changes but h/p |λ̃ + S u|².
struct ContactCost::Kernel {
  const ContactCost& cost;
  const AtEnds& c;
  double& result;

  template <bem::Division>
  EPAFI_INLINE void run() const {
    const Pack zero{};
    Pack whole{};
    for (std::size_t k = 0; k < cost.points_.size(); ++k) {
      const Eight& point = cost.points_[k];
      const auto number = [&](Number n) -> const Pack& {
        return bem::load(point[n].lane);
      };
      const Pack changeX = c.start.x * number(Start) + c.end.x * number(End);
      const Pack changeY = c.start.y * number(Start) + c.end.y * number(End);
      Pack pressure =
          number(Pressure) + changeX * number(NormalX) + changeY * number(NormalY);
      const Pack shear =
          number(Shear) + changeY * number(NormalX) - changeX * number(NormalY);
      Pack bound = number(Bound);
      if (!cost.laws_.empty())
        for (int lane = 0; lane < bem::lanes; ++lane) {
          const auto& [law, open] = cost.laws_[k * bem::lanes + bem::at(lane)];
          bound[lane] = pressure[lane] > 0 ? law.bound(pressure[lane]) : open;
        }
      const Pack slip = number(Slip);
      const Pack length = slip < 0.0 ? -slip : slip;
      Pack along = slip < 0.0 ? -shear : shear;
      along = along > bound ? bound : along;
      along = along < -bound ? -bound : along;
      Pack excess = (shear < 0.0 ? -shear : shear) - bound;
      positivePart(excess);
      Pack tension = zero - pressure;
      positivePart(tension);
      positivePart(pressure);
      const auto factor = [&](Source source) {
        return cost.factors_[static_cast<std::size_t>(source)];
      };
      Pack sum = (factor(Source::Tension) * cost.size_) * (tension * tension) +
                 (factor(Source::Bound) * cost.size_) * (excess * excess);
      addLostWork(pressure, number(Slack), cost.stiffness_,
                  factor(Source::Complementarity), sum);
      addLostWork(bound - along, length, cost.stiffness_, factor(Source::Slip), sum);
      whole += number(Weight) * sum;
    }
    result = 0;
    for (int lane = 0; lane < bem::lanes; ++lane)
      result += whole[lane];
  }
};

ContactCost::ContactCost(const contact::Solved& solved, const ContactElement& element,
                         const AtEnds& moments, const Contributions& factors,
                         double shearModulus, KnownPlaces& places)
    : moments_(moments), factors_(factors) {
  const bem::Mesh& mesh = solved.space.mesh();
  const bem::Element& geometry = mesh[element.element];
  const int p = element.degree;
  size_ = 2 * geometry.half / p;
  stiffness_ = shearModulus / size_;
  weight_ = 2.0 / p * of(factors_, Source::Contact);
  self_ = bem::endValues(p, 1).end;
  other_ = bem::endValues(p, 1).start;

  const ContactProfiles profiles = contactProfiles(solved, element, {}, places);
  const Vec2 across = profiles.direction(0);
  const bem::Rule& rule = bem::gaussLegendre(p + 10);
  double steepest = 0;
  // the jump of bonded sides is not the multiplier's to change
  for (std::size_t q = 0; q < rule.points.size() && !element.ties(); ++q) {
    const double t = rule.points[q];
    const double pressure = profiles.pressure(t);
    const contact::PointLaw friction = element.condition->friction.at(
        mesh.physicalPoint(element.element, t), solved.units.stress);
    const Vec2 normal = profiles.direction(t);
    const bem::EndValues e = bem::endValues(p, t);
    add(q, {normal.x, normal.y, rule.weights[q] * mesh.measure(element.element, t),
            e.start / geometry.half, e.end / geometry.half, pressure, profiles.shear(t),
            positive(profiles.opening(t)), profiles.tangential(t),
            friction.bound(pressure)});
    if (friction.followsPressure())
      laws_.push_back({friction, friction.bound(0)});
    steepest = std::max(steepest, friction.slope(pressure));
  }
  if (!laws_.empty())
    laws_.resize(points_.size() * bem::lanes);
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
  const double sum =
      weight_ * (2 * dot(moments_.start, c.start) + 2 * dot(moments_.end, c.end) +
                 self_ * (dot(c.start, c.start) + dot(c.end, c.end)) +
                 2 * other_ * dot(c.start, c.end));
  double terms = 0;
  bem::dispatch(Kernel{*this, c, terms});
  return sum + terms;
}

void ContactCost::add(std::size_t q, const std::array<double, Numbers>& point) {
  if (q % bem::lanes == 0)
    points_.emplace_back();
  for (std::size_t n = 0; n < Numbers; ++n)
    points_.back()[n].lane[q % bem::lanes] = point[n];
}

}  // namespace epafi::adaptivity
