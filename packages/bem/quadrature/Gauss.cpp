#include "bem/quadrature/Gauss.hpp"

#include "bem/base/Error.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

constexpr int largestRule = 96;

struct Evaluated {
  long double value;
  long double slope;
};

Evaluated legendre(int n, long double t) {
  long double current = 1;
  long double previous = 0;
  for (int k = 0; k < n; ++k) {
    const long double next = ((2 * k + 1) * t * current - k * previous) / (k + 1);
    previous = current;
    current = next;
  }
  return {current, n * (t * current - previous) / (t * t - 1)};
}

Rule makeRule(int n) {
  Rule rule{Vector(n), Vector(n)};
  const long double pi = std::acos(-1.0L);
  for (int i = 0; i < n; ++i) {
    long double t = std::cos(pi * (i + 0.75L) / (n + 0.5L));
    for (int step = 0; step < 50; ++step) {
      const Evaluated p = legendre(n, t);
      const long double change = p.value / p.slope;
      t -= change;
      if (std::abs(change) < 1e-19L)
        break;
    }
    const long double slope = legendre(n, t).slope;
    rule.points[n - 1 - i] = static_cast<double>(t);
    rule.weights[n - 1 - i] = static_cast<double>(2 / ((1 - t * t) * slope * slope));
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
