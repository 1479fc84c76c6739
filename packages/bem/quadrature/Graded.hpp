#pragma once

#include "bem/quadrature/Gauss.hpp"

namespace epafi::bem {

/// A point t of [-1, 1], accurate relative to both ends.
struct EndPoint {
  double t = 0;
  double fromStart = 0;  ///< t + 1
  double toEnd = 0;      ///< 1 - t
};

struct GradedRule {
  std::vector<EndPoint> points;
  Vector weights;
  int size() const { return static_cast<int>(points.size()); }
};

/// A singularity of the integrand: projection t on the line of [-1, 1], `distance` from that
/// line (0: on it).
struct Feature {
  double t = 0;
  double distance = 0;
};

/// Composite Gauss rule with `order` points on intervals that shrink geometrically (factor
/// 0.2) toward every feature, until an interval is at most four times as long as its distance
/// to the feature, or at most `smallest` if the feature is on the line.
///
/// The error for (t - f) log|t - f| is 1e-14 with order 17 and smallest 1e-6: n points have
/// the error ε² / n⁴ on the last interval, of length ε.
GradedRule gradedRule(const std::vector<Feature>& features, int order, double smallest);

/// Graded rule for polynomials of a degree times logarithms, with far fewer points than
/// gradedRule if features touch [-1, 1] (closer than 1e-12): on an interval that touches a
/// feature, the distance s from it is a power of the new variable.  Such intervals touch features
/// at one end only (otherwise they are halved) and are at most as long as their distance from
/// other features.
/// \param power 5 for s log s, 7 for log s; error 1e-13
GradedRule touchingRule(const std::vector<Feature>& features, int degree, int power);

/// Graded rule of moderate accuracy with far fewer points: at features at -1 or 1 grading ends
/// with intervals of 1 % of [-1, 1] and a substitution with the fourth power of the distance,
/// which makes powers of logarithms smooth.  Error with order 7: 1e-5 for log², 1e-6 for
/// differences of two logarithms with singularities close together.
/// \param cuts places in [-1, 1] where the integrand jumps or has a kink
GradedRule softenedRule(const std::vector<Feature>& features, int order,
                        Vector cuts = {});

}  // namespace epafi::bem
