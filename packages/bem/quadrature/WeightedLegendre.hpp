#pragma once

#include "bem/basis/Legendre.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// Largest number of Gauss points that tables are kept for.
constexpr int largestGaussOrder = 63;

/// Legendre polynomials times the weights of a Gauss rule: table[q][k] = w_q P_k(t_q),
/// k = 0 ... largestDegree + 2.
using WeightedLegendre = std::vector<std::array<double, largestDegree + 3>>;

/// Of the rule with `order` points, 1 <= order <= largestGaussOrder.  Made once and kept.
const WeightedLegendre& weightedLegendre(int order);

}  // namespace epafi::bem
