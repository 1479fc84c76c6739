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
/// Points are the zeros of the Legendre polynomial Pₙ, computed in extended precision; weights
/// wᵢ = 2 / ((1 - tᵢ²) Pₙ'(tᵢ)²).                                          [DLMF 3.5(v)]
/// A rule is computed once and stored.
/// \throws InputError unless 1 <= n <= 128
const Rule& gaussLegendre(int n);

/// Gauss rule for polynomials of a degree times a smooth function given in the scene (load,
/// gap, bound).
inline const Rule& gaussForGiven(int degree) { return gaussLegendre(degree + 12); }

/// Largest number of Gauss points with a weightedLegendre table.
constexpr int largestGaussOrder = 63;

/// Legendre polynomials times the weights of a Gauss rule: table[q][k] = w_q P_k(t_q),
/// k = 0 ... largestDegree + 2.
using WeightedLegendre = std::vector<std::array<double, largestDegree + 3>>;

/// Table of the rule with `order` points, computed once.  \pre 1 <= order <= largestGaussOrder
const WeightedLegendre& weightedLegendre(int order);

}  // namespace epafi::bem
