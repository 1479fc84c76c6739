#include "bem/quadrature/Piecewise.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>

namespace epafi::bem {

Vector signChanges(const Profile& f, int degree) {
  const int intervals = 8 * (degree + 1);
  const auto isSmall = [](double a, double b) { return b - a <= 1e-15; };
  Vector changes;
  double low = -1;
  double valueLow = f(low);
  for (int i = 0; i < intervals; ++i) {
    const double next = i + 1 == intervals ? 1 : -1 + 2.0 * (i + 1) / intervals;
    const double valueNext = f(next);
    if ((valueLow < 0) != (valueNext < 0)) {
      std::uintmax_t steps = 100;
      const auto [before, behind] = boost::math::tools::toms748_solve(
          f, low, next, valueLow, valueNext, isSmall, steps);
      changes.push_back(0.5 * (before + behind));
    }
    low = next;
    valueLow = valueNext;
  }
  return changes;
}

Rule piecewiseRule(Vector breaks, int order) {
  breaks.push_back(-1);
  breaks.push_back(1);
  std::sort(breaks.begin(), breaks.end());
  const Rule& gauss = gaussLegendre(order);
  Rule rule;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double half = 0.5 * (breaks[k + 1] - breaks[k]);
    const double middle = 0.5 * (breaks[k + 1] + breaks[k]);
    if (!(half > 0))
      continue;
    for (std::size_t q = 0; q < gauss.points.size(); ++q) {
      rule.points.push_back(middle + half * gauss.points[q]);
      rule.weights.push_back(half * gauss.weights[q]);
    }
  }
  return rule;
}

}  // namespace epafi::bem
