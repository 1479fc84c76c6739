#include "bem/quadrature/Gauss.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/MadeOnce.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace epafi::bem {

namespace {

/// What softened rules of corners with an arc take at the largest degree is 101.
constexpr int largestRule = 128;

Rule makeRule(int n) {
  Rule rule{Vector(n), Vector(n)};
  // those that are not negative, in rising order
  const std::vector<long double> zeros = boost::math::legendre_p_zeros<long double>(n);
  for (std::size_t k = 0; k < zeros.size(); ++k) {
    const long double t = zeros[k];
    const long double slope = boost::math::legendre_p_prime(n, t);
    const int i = n / 2 + static_cast<int>(k);
    rule.points[n - 1 - i] = static_cast<double>(-t);
    rule.points[i] = static_cast<double>(t);
    rule.weights[i] = rule.weights[n - 1 - i] =
        static_cast<double>(2 / ((1 - t * t) * slope * slope));
  }
  return rule;
}

}  // namespace

const Rule& gaussLegendre(int n) {
  static MadeOnce<Rule, largestRule> rules(makeRule);
  if (n < 1 || n > largestRule)
    throw InputError("Gauss rule with ", n, " points; 1 to ", largestRule, " exist");
  return rules[n];
}

namespace {

WeightedLegendre makeTable(int order) {
  const Rule& rule = gaussLegendre(order);
  WeightedLegendre table(rule.points.size());
  for (std::size_t q = 0; q < table.size(); ++q) {
    legendreValues(largestDegree + 2, rule.points[q], table[q].data());
    for (double& value : table[q])
      value *= rule.weights[q];
  }
  return table;
}

}  // namespace

const WeightedLegendre& weightedLegendre(int order) {
  static MadeOnce<WeightedLegendre, largestGaussOrder> tables(makeTable);
  return tables[order];
}

}  // namespace epafi::bem
