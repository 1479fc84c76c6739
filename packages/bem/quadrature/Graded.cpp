#include "bem/quadrature/Graded.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

// Intervals of four times their distance from the feature, each a fifth as far as the one
// before: about the fewest points per decade for 1e-14 (24; intervals of the distance
// itself take 29), by the ellipse of log|t - f| about the interval.
constexpr double largestRatio = 4;
constexpr double grading = 1 / (1 + largestRatio);

/// An interval of [-1, 1], its ends counted from whichever end of [-1, 1] is nearer.
struct Interval {
  EndPoint from;
  EndPoint to;
  double length() const {
    // from the side where both ends have small numbers, so that nothing cancels
    return from.fromStart < to.toEnd ? to.fromStart - from.fromStart
                                     : from.toEnd - to.toEnd;
  }
};

EndPoint fromStart(double s) { return {s - 1, s, 2 - s}; }
EndPoint toEnd(double s) { return {1 - s, 2 - s, s}; }

/// The point a fraction f from a to b.
EndPoint between(const EndPoint& a, const EndPoint& b, double f) {
  if (a.fromStart + b.fromStart < 2)
    return fromStart(a.fromStart + f * (b.fromStart - a.fromStart));
  return toEnd(a.toEnd + f * (b.toEnd - a.toEnd));
}

double separation(const Interval& interval, const Feature& feature) {
  const double along =
      std::max({0.0, interval.from.t - feature.t, feature.t - interval.to.t});
  return std::hypot(along, feature.distance);
}

/// `smallest`: for each feature, how far intervals are cut for its sake.
void refine(const Interval& interval, const std::vector<Feature>& features,
            const std::vector<double>& smallest, std::vector<Interval>& leaves) {
  const double length = interval.length();
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Feature& feature = features[k];
    if (length <= smallest[k] ||
        length <= (1 + 1e-12) * largestRatio * separation(interval, feature))
      continue;
    // Split at the feature's foot if it lies inside, else next to the end that is nearer.
    const double lo = interval.from.t;
    const double hi = interval.to.t;
    EndPoint cut;
    if (feature.t > lo + 1e-3 * length && feature.t < hi - 1e-3 * length)
      cut = between(interval.from, interval.to, (feature.t - lo) / (hi - lo));
    else
      cut = between(interval.from, interval.to,
                    feature.t < 0.5 * (lo + hi) ? grading : 1 - grading);
    refine({interval.from, cut}, features, smallest, leaves);
    refine({cut, interval.to}, features, smallest, leaves);
    return;
  }
  leaves.push_back(interval);
}

/// The end of an interval that a feature lies at, within a hundredth of its length.
enum class Touches { Nothing, From, To };

Touches touches(const Interval& interval, const std::vector<Feature>& features) {
  const double near = 0.01 * interval.length();
  for (const Feature& feature : features) {
    if (std::hypot(feature.t - interval.from.t, feature.distance) <= near)
      return Touches::From;
    if (std::hypot(feature.t - interval.to.t, feature.distance) <= near)
      return Touches::To;
  }
  return Touches::Nothing;
}

}  // namespace

GradedRule softenedRule(const std::vector<Feature>& features, int order) {
  std::vector<double> smallest;
  for (const Feature& feature : features) {
    const bool atEnd = std::hypot(1 - std::abs(feature.t), feature.distance) < 1e-9;
    smallest.push_back(atEnd ? 0.02 : 1e-6);
  }
  std::vector<Interval> leaves;
  refine({fromStart(0), toEnd(0)}, features, smallest, leaves);
  const Rule& gauss = gaussLegendre(order);
  GradedRule rule;
  for (const Interval& leaf : leaves) {
    const Touches end = touches(leaf, features);
    for (int i = 0; i < order; ++i) {
      const double s = 0.5 * (1 + gauss.points[static_cast<std::size_t>(i)]);
      double weight = 0.5 * leaf.length() * gauss.weights[static_cast<std::size_t>(i)];
      if (end == Touches::Nothing) {
        rule.points.push_back(between(leaf.from, leaf.to, s));
      } else {
        const double power = s * s * s * s;
        rule.points.push_back(end == Touches::From ? between(leaf.from, leaf.to, power)
                                                   : between(leaf.to, leaf.from, power));
        weight *= 4 * s * s * s;
      }
      rule.weights.push_back(weight);
    }
  }
  return rule;
}

GradedRule gradedRule(const std::vector<Feature>& features, int order, double smallest) {
  std::vector<Interval> leaves;
  refine({fromStart(0), toEnd(0)}, features,
         std::vector<double>(features.size(), smallest), leaves);
  const Rule& gauss = gaussLegendre(order);
  GradedRule rule;
  rule.points.reserve(leaves.size() * static_cast<std::size_t>(order));
  rule.weights.reserve(rule.points.capacity());
  for (const Interval& leaf : leaves)
    for (int i = 0; i < order; ++i) {
      rule.points.push_back(between(leaf.from, leaf.to, 0.5 * (1 + gauss.points[i])));
      rule.weights.push_back(0.5 * leaf.length() * gauss.weights[i]);
    }
  return rule;
}

}  // namespace epafi::bem
