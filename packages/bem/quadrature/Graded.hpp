#pragma once

#include "bem/quadrature/Gauss.hpp"

namespace epafi::bem {

/// A point t of [-1, 1] known accurately near both ends.
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

/// A place on the line of [-1, 1] where the integrand is not smooth: at t, `distance` off
/// the line (0: on it).
struct Feature {
  double t = 0;
  double distance = 0;
};

/// Composite Gauss rule with `order` points on intervals that shrink geometrically
/// (factor 0.2) toward every feature, until an interval is no longer than four times its
/// distance from the feature, or than `smallest` where the feature lies on the line.
///
/// Integrands like (t - f) log|t - f| are met to 1e-14 with order 17, smallest 1e-6: a
/// rule of n points loses ε² / n⁴ on the last interval ε.
GradedRule gradedRule(const std::vector<Feature>& features, int order, double smallest);

/// How t runs on an interval that touches a feature: with a power of the distance from it,
/// at so many Gauss points.
struct Softening {
  int power = 1;
  int order = 1;
};

/// The same with far fewer points where features touch [-1, 1] (closer than 1e-12): an
/// interval that does at one end is not cut for their sake, and softened; other features are
/// as far from it as it is long, and it is cut in half where both of its ends touch one.  Elsewhere intervals shrink toward features as above, with
/// `order` points on each.
GradedRule touchingRule(const std::vector<Feature>& features, int order,
                        const Softening& softening);

/// The same for moderate accuracy with far fewer points: at features that lie at -1 or 1
/// grading ends at intervals of 1 % of [-1, 1], on which t runs with the fourth power of
/// the distance, which makes powers of logarithms smooth.  With order 7 integrals of log²
/// are met to 1e-5, those of differences of two logarithms close together to 1e-6.
/// `cuts`, within [-1, 1]: where the integrand jumps or bends, smooth on both sides.
GradedRule softenedRule(const std::vector<Feature>& features, int order,
                        Vector cuts = {});

}  // namespace epafi::bem
