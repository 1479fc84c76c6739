#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <array>

namespace epafi::bem {

/// Coefficients of c₀ P₀ + ... on [-1, 1] up to largestDegree; those beyond the degree are zero.
template <class Value>
using LegendreSeries = std::array<Value, largestDegree + 1>;

/// Σ c[k] P_k(t), k = 0 ... degree, by Clenshaw's recurrence; 0 for degree -1.  Series: a
/// container with operator[].
template <class Series>
auto evaluate(const Series& series, int degree, double t) {
  using Value = typename Series::value_type;
  Value next = 0;
  Value here = 0;
  for (int k = degree; k >= 0; --k) {
    const Value before =
        series[k] + (2 * k + 1.0) / (k + 1) * t * here - (k + 1.0) / (k + 2) * next;
    next = here;
    here = before;
  }
  return here;
}

/// Legendre series of a polynomial of at most this degree, exact up to rounding.
template <class Function>
auto project(const Function& function, int degree) {
  LegendreSeries<decltype(function(0.0))> series{};
  const Rule& rule = gaussLegendre(degree + 1);
  std::array<double, largestDegree + 1> legendre{};
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    legendreValues(degree, rule.points[q], legendre.data());
    const auto value = rule.weights[q] * function(rule.points[q]);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
      series[k] += (static_cast<double>(k) + 0.5) * legendre[k] * value;
  }
  return series;
}

}  // namespace epafi::bem
