#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/basis/Legendre.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// A quadrature rule:  ∫ f dt ≈ Σ weights[i] f(points[i]).
struct Rule {
  Vector points;
  Vector weights;
  int size() const { return static_cast<int>(points.size()); }
};

/// The n-point Gauss-Legendre rule on [-1, 1], exact for polynomials of degree 2n-1.
///
/// Points are the zeros of the Legendre polynomial Pₙ in extended precision; wᵢ = 2 / ((1
/// - tᵢ²) Pₙ'(tᵢ)²).                                                       [DLMF 3.5(v)]
/// Rules are made once and kept.
/// \throws InputError unless 1 <= n <= 128.
const Rule& gaussLegendre(int n);

/// The rule for polynomials of a degree times what a scene gives as a function of place (loads,
/// gaps, bounds): smooth, and no polynomial.
inline const Rule& gaussForGiven(int degree) { return gaussLegendre(degree + 12); }

/// Largest number of Gauss points that tables are kept for.
constexpr int largestGaussOrder = 63;

/// Legendre polynomials times the weights of a Gauss rule: table[q][k] = w_q P_k(t_q),
/// k = 0 ... largestDegree + 2.
using WeightedLegendre = std::vector<std::array<double, largestDegree + 3>>;

/// Of the rule with `order` points, 1 <= order <= largestGaussOrder.  Made once and kept.
const WeightedLegendre& weightedLegendre(int order);

}  // namespace epafi::bem
