#include "bem/quadrature/Gauss.hpp"

#include "bem/base/Error.hpp"

#include <boost/math/special_functions/legendre.hpp>

namespace epafi::bem {

namespace {

constexpr int largestRule = 96;

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

std::vector<Rule> makeRules() {
  std::vector<Rule> rules;
  for (int n = 1; n <= largestRule; ++n)
    rules.push_back(makeRule(n));
  return rules;
}

}  // namespace

const Rule& gaussLegendre(int n) {
  static const std::vector<Rule> rules = makeRules();
  if (n < 1 || n > largestRule)
    throw InputError(
        message("Gauss rule with ", n, " points; 1 to ", largestRule, " exist"));
  return rules[static_cast<std::size_t>(n - 1)];
}

}  // namespace epafi::bem
