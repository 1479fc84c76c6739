#pragma once

#include "adaptivity/estimate/ContactTerms.hpp"
#include "bem/simd/Pack.hpp"

#include <array>
#include <vector>

namespace epafi::adaptivity {

/// What a contact element adds to the squared estimate as a function of the correction of
/// its multiplier, up to a constant: h/p |λ̃ + S u|² exactly, the other terms by one Gauss
/// rule.  For choosing a correction, of which any will do, not for the estimate itself.
class ContactCost {
 public:
  /// `moments`: ∫ r e(-t) ds and ∫ r e(t) ds of r = λʰ + S u, see endValue.
  ContactCost(const contact::Solved& solved, const ContactElement& element,
              const AtEnds& moments, const Contributions& factors, double shearModulus);

  double operator()(const AtEnds& correction) const;

  /// Of h/p |λ̃ + S u|²: half its derivative, and the half of its second one by the start
  /// or by the end.
  AtEnds slope(const AtEnds& correction) const;
  double curvature() const { return weight_ * self_; }

  /// What of the cost corrections can change: the other terms without any, and the most
  /// that one at an end takes from h/p |λ̃ + S u|².
  double scale() const { return scale_; }

  /// Along these a correction leaves some term as it is: pressure, shear, and the two in
  /// the ratio of friction; on an arc those of its middle.
  const std::vector<bem::Vec2>& directions() const { return directions_; }

 private:
  /// What stands at a point of the rule.  Ends: e(-t)/half and e(t)/half; Slack: (g-uₙ)⁺; Bound:
  /// s where it does not follow the pressure.
  enum Number {
    NormalX,
    NormalY,
    Weight,
    Start,
    End,
    Pressure,
    Shear,
    Slack,
    Slip,
    Bound,
    Numbers
  };
  /// Of eight points; those beyond the last have no weight.
  using Eight = std::array<bem::AlignedLane, Numbers>;
  struct Kernel;

  void add(std::size_t q, const std::array<double, Numbers>& point);

  double size_;       ///< h/p
  double stiffness_;  ///< μ p/h
  double weight_;
  double self_;
  double other_;
  double scale_;
  AtEnds moments_;
  Contributions factors_;
  std::vector<Eight> points_;
  std::vector<contact::PointLaw>
      laws_;  ///< of the points, where they follow the pressure
  std::vector<bem::Vec2> directions_;
};

}  // namespace epafi::adaptivity
