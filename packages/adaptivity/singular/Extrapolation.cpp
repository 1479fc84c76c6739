#include "adaptivity/singular/Extrapolation.hpp"

#include "bem/algebra/LuFactor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::adaptivity {

namespace {

using Parabola = std::array<double, 3>;  // c₀ + c₁ ξ + c₂ ξ²

/// By the normal equations: three unknowns on |ξ| <= 1 leave digits enough.
std::optional<Parabola> fit(const Samples& samples) {
  bem::Matrix matrix(3, 3);
  bem::Vector right(3);
  for (std::size_t k = 0; k < samples.places.size(); ++k) {
    const double x = samples.places[k];
    const Parabola powers = {1, x, x * x};
    for (std::size_t i = 0; i < 3; ++i) {
      right[i] += powers[i] * samples.values[k];
      for (std::size_t j = 0; j < 3; ++j)
        matrix(i, j) += powers[i] * powers[j];
    }
  }
  const bem::LuFactor factor(std::move(matrix));
  if (!factor.isRegular())
    return {};
  factor.solve(right);
  return Parabola{right[0], right[1], right[2]};
}

/// The zero with the smaller modulus.
std::optional<double> smallerZero(const Parabola& c) {
  const double discriminant = c[1] * c[1] - 4 * c[0] * c[2];
  if (!(discriminant >= 0))
    return {};
  const double sum = std::abs(c[1]) + std::sqrt(discriminant);
  if (!(sum > 0))
    return {};
  return (c[1] > 0 ? -2 : 2) * c[0] / sum;
}

}  // namespace

std::optional<double> beginOfGrowth(const Samples& samples, double guess) {
  Samples scaled;
  double reach = 0;
  for (std::size_t k = 0; k < samples.places.size(); ++k)
    if (samples.values[k] > 0) {
      scaled.places.push_back(samples.places[k] - guess);
      scaled.values.push_back(std::cbrt(samples.values[k] * samples.values[k]));
      reach = std::max(reach, std::abs(scaled.places.back()));
    }
  if (scaled.places.size() < 4)
    return {};
  const double largest = *std::max_element(scaled.values.begin(), scaled.values.end());
  for (double& x : scaled.places)
    x /= reach;
  for (double& v : scaled.values)
    v /= largest;
  const auto parabola = fit(scaled);
  const auto zero = parabola ? smallerZero(*parabola) : std::nullopt;
  if (!zero)
    return {};
  return guess + reach * *zero;
}

}  // namespace epafi::adaptivity
