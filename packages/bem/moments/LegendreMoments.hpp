#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/geometry/Curve.hpp"

#include <array>

namespace epafi::bem {

/// Integrals of Legendre polynomials over [-1, 1] against the kernels' building blocks,
/// in closed form by the Legendre functions of the second kind Q_j.
/// [doc/theory/operators.md]
///
///   c[j] = ∫ P_j/(z-t) dt = 2 Q_j(z),   l[j] = Re ∫ P_j log(z-t) dt,
///   d[j] = ∫ P_j/(z-t)² dt = -2 Q_j'(z)
///
/// Relative error about 1e-15 for j <= 2 and 1e-13 for j <= 25, from 1e-12 off the
/// element or its ends to |z| = 1e6.
template <int Longest>
struct LegendreMomentsUpTo {
  static constexpr int longest = Longest;
  std::array<Complex, Longest + 2> c{};
  std::array<Complex, Longest + 1> d{};
  std::array<double, Longest + 1> l{};
};

using LegendreMoments = LegendreMomentsUpTo<largestDegree + 1>;

/// For series beyond the polynomials of a mesh, see ArcWeights.
constexpr int longestSeries = 62;
using LongLegendreMoments = LegendreMomentsUpTo<longestSeries>;

enum class Need { CandL, CandD, All };

/// The moments for j = 0 ... degree (degree <= longest).  d is left alone on the
/// element, where ∫ P_j/(z-t)² does not exist.
void evaluateMoments(const RelativeTarget& target, int degree, Need need,
                     LegendreMoments& moments);
void evaluateMoments(const RelativeTarget& target, int degree, Need need,
                     LongLegendreMoments& moments);

}  // namespace epafi::bem
