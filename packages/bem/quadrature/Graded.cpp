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
  const double s = a.fromStart + f * (b.fromStart - a.fromStart);
  return s < 1 ? fromStart(s) : toEnd(a.toEnd + f * (b.toEnd - a.toEnd));
}

/// Counted from the end of [-1, 1] that the feature is near: there t tells short intervals apart
/// no more.
double separation(const Interval& interval, const Feature& feature) {
  const EndPoint& from = interval.from;
  const EndPoint& to = interval.to;
  const double s = 1 - std::abs(feature.t);
  const double along = feature.t < 0
                           ? std::max({0.0, from.fromStart - s, s - to.fromStart})
                           : std::max({0.0, s - from.toEnd, to.toEnd - s});
  return std::hypot(along, feature.distance);
}

/// The end of an interval that a feature lies at.
enum class Touches { Nothing, From, To };

/// What touches an interval whatever its length: an end of [-1, 1] and rounding.
constexpr double closest = 1e-12;

/// A feature within `distance` of an end.
Touches touches(const Interval& interval, const Feature& feature, double distance) {
  const EndPoint& from = interval.from;
  const EndPoint& to = interval.to;
  // an end of [-1, 1] from its own side, so that short intervals count right
  const auto apart = [&](const EndPoint& end) {
    const double along =
        feature.t < 0 ? end.fromStart - (1 + feature.t) : end.toEnd - (1 - feature.t);
    return std::hypot(along, feature.distance);
  };
  if (apart(from) <= distance)
    return Touches::From;
  return apart(to) <= distance ? Touches::To : Touches::Nothing;
}

/// `smallest`: for each feature, how far intervals are cut for its sake; zero: not at all
/// where they touch it at one end alone.
void refine(const Interval& interval, const std::vector<Feature>& features,
            const std::vector<double>& smallest, std::vector<Interval>& leaves) {
  const double length = interval.length();
  bool atStart = false;
  bool atEnd = false;
  for (std::size_t k = 0; k < features.size(); ++k)
    if (smallest[k] == 0) {
      const Touches end = touches(interval, features[k], closest);
      atStart = atStart || end == Touches::From;
      atEnd = atEnd || end == Touches::To;
    }
  if (atStart && atEnd) {  // a leaf is softened at one end
    const EndPoint cut = between(interval.from, interval.to, 0.5);
    refine({interval.from, cut}, features, smallest, leaves);
    refine({cut, interval.to}, features, smallest, leaves);
    return;
  }
  const double ratio = atStart || atEnd ? 1 : largestRatio;
  for (std::size_t k = 0; k < features.size(); ++k) {
    const Feature& feature = features[k];
    if (length <= smallest[k] ||
        length <= (1 + 1e-12) * ratio * separation(interval, feature) ||
        (smallest[k] == 0 && touches(interval, feature, closest) != Touches::Nothing))
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

/// Adds a Gauss rule on a leaf, on which the distance from `end` runs with a power.
void append(const Interval& leaf, Touches end, int power, int order, GradedRule& rule) {
  const Rule& gauss = gaussLegendre(order);
  for (std::size_t i = 0; i < gauss.points.size(); ++i) {
    const double s = 0.5 * (1 + gauss.points[i]);
    const double weight = 0.5 * leaf.length() * gauss.weights[i];
    if (end == Touches::Nothing) {
      rule.points.push_back(between(leaf.from, leaf.to, s));
      rule.weights.push_back(weight);
      continue;
    }
    double slope = power;
    for (int k = 1; k < power; ++k)
      slope *= s;
    const double far = slope * s / power;
    rule.points.push_back(end == Touches::From ? between(leaf.from, leaf.to, far)
                                               : between(leaf.to, leaf.from, far));
    rule.weights.push_back(weight * slope);
  }
}

Touches touchesAny(const Interval& leaf, const std::vector<Feature>& features,
                   double distance) {
  for (const Feature& feature : features)
    if (const Touches end = touches(leaf, feature, distance); end != Touches::Nothing)
      return end;
  return Touches::Nothing;
}

}  // namespace

GradedRule softenedRule(const std::vector<Feature>& features, int order, Vector cuts) {
  std::vector<double> smallest;
  for (const Feature& feature : features) {
    const bool atEnd = std::hypot(1 - std::abs(feature.t), feature.distance) < 1e-9;
    smallest.push_back(atEnd ? 0.02 : 1e-6);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> leaves;
  EndPoint from = fromStart(0);
  for (const double t : cuts)
    if (t > from.t + closest && t < 1 - closest) {
      const EndPoint to = t < 0 ? fromStart(1 + t) : toEnd(1 - t);
      refine({from, to}, features, smallest, leaves);
      from = to;
    }
  refine({from, toEnd(0)}, features, smallest, leaves);
  GradedRule rule;
  for (const Interval& leaf : leaves)
    append(leaf, touchesAny(leaf, features, 0.01 * leaf.length()), 4, order, rule);
  return rule;
}

GradedRule touchingRule(const std::vector<Feature>& features, int degree, int power) {
  const int order = 17 + degree / 2;
  const int softened = power == 5 ? 20 + 7 * degree / 6 : 26 + 27 * degree / 20;
  std::vector<Interval> leaves;
  refine({fromStart(0), toEnd(0)}, features, std::vector<double>(features.size()),
         leaves);
  GradedRule rule;
  const auto most = static_cast<std::size_t>(std::max(order, softened));
  rule.points.reserve(leaves.size() * most);
  rule.weights.reserve(leaves.size() * most);
  for (const Interval& leaf : leaves) {
    const Touches end = touchesAny(leaf, features, closest);
    append(leaf, end, power, end == Touches::Nothing ? order : softened, rule);
  }
  return rule;
}

GradedRule gradedRule(const std::vector<Feature>& features, int order, double smallest) {
  std::vector<Interval> leaves;
  refine({fromStart(0), toEnd(0)}, features,
         std::vector<double>(features.size(), smallest), leaves);
  GradedRule rule;
  for (const Interval& leaf : leaves)
    append(leaf, Touches::Nothing, 1, order, rule);
  return rule;
}

}  // namespace epafi::bem
