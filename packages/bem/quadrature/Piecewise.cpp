#include "bem/quadrature/Piecewise.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>

namespace epafi::bem {

Vector signSamples(int degree) {
  const int intervals = 8 * (degree + 1);
  Vector places;
  for (int i = 0; i < intervals; ++i)
    places.push_back(-1 + 2.0 * i / intervals);
  places.push_back(1);
  return places;
}

Vector signChanges(const Profile& f, const Vector& places, const Vector& values,
                   double error) {
  const auto isSmall = [error](double a, double b) { return b - a <= error; };
  Vector changes;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    if ((values[i] < 0) != (values[i + 1] < 0)) {
      std::uintmax_t steps = 100;
      const auto [before, behind] = boost::math::tools::toms748_solve(
          f, places[i], places[i + 1], values[i], values[i + 1], isSmall, steps);
      changes.push_back(0.5 * (before + behind));
    }
  return changes;
}

Vector signChanges(const Profile& f, int degree) {
  const Vector places = signSamples(degree);
  Vector values;
  for (const double place : places)
    values.push_back(f(place));
  return signChanges(f, places, values);
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
