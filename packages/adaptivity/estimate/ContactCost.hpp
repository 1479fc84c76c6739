#pragma once

#include "adaptivity/estimate/ContactTerms.hpp"
#include "bem/simd/Pack.hpp"

#include <array>
#include <vector>

namespace epafi::adaptivity {

/// Contribution of a contact element to the squared estimate as a function of the correction
/// of its multiplier, up to a constant: h/p |λ̃ + S u|² exactly, the other terms by one Gauss
/// rule.  Used to choose a correction (any is valid), not for the estimate itself.
class ContactCost {
 public:
  /// `moments`: ∫ r e(-t) ds and ∫ r e(t) ds of r = λʰ + S u, see endValue.
  ContactCost(const contact::Solved& solved, const ContactElement& element,
              const AtEnds& moments, const Contributions& factors, double shearModulus,
              KnownPlaces& places);

  double operator()(const AtEnds& correction) const;

  /// Half the gradient of h/p |λ̃ + S u|², and half its second derivative with respect to a
  /// component at the start or at the end.
  AtEnds slope(const AtEnds& correction) const;
  double curvature() const { return weight_ * self_; }

  /// Size of the part of the cost that depends on corrections: the other terms at zero, plus the
  /// largest decrease of h/p |λ̃ + S u|² by a correction at one end.
  double scale() const { return scale_; }

  /// Search directions that do not change one of the terms: pressure, shear, and both in the
  /// ratio of friction; on an arc at its midpoint.
  const std::vector<bem::Vec2>& directions() const { return directions_; }

 private:
  /// Data of a quadrature point.  Start, End: e(-t)/half and e(t)/half; Slack: (g-uₙ)⁺; Bound: s
  /// if it does not depend on the pressure.
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
  /// Data of eight points; points beyond the last have weight zero.
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
  /// Of a point whose bound follows the pressure.
  struct Law {
    contact::PointLaw law;
    double open = 0;  ///< the bound without pressure
  };
  std::vector<Law> laws_;  ///< of the points, or none
  std::vector<bem::Vec2> directions_;
};

}  // namespace epafi::adaptivity
