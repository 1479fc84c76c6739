#pragma once

#include "bem/basis/Legendre.hpp"

#include <array>
#include <complex>

namespace epafi::bem {

using Complex = std::complex<double>;

/// A target point x seen from an element:  z = a + ib,  a = 2(x-m)·τ/h,  b = 2(x-m)·n/h,
/// so that x - y(t) = (h/2) ((a-t) τ + b n).  Both z-1 and z+1 are kept, since one of
/// them is tiny near an end.  b < 0 on the body's side; b = 0 exactly on the element's
/// own edge.
struct RelativeTarget {
  Complex zMinus1;
  Complex zPlus1;
  double b() const { return zMinus1.imag(); }
  /// z itself, from the offset that loses no digits.
  Complex z() const {
    return std::norm(zMinus1) < std::norm(zPlus1) ? 1.0 + zMinus1 : zPlus1 - 1.0;
  }
  /// On the element, where integrals are principal values.
  bool onElement() const { return b() == 0 && zMinus1.real() < 0 && zPlus1.real() > 0; }
};

/// Integrals of Legendre polynomials over [-1, 1] against the kernels' building blocks,
/// in closed form by the Legendre functions of the second kind Q_j.
/// [doc/theory/operators.md]
///
///   c[j] = ∫ P_j/(z-t) dt = 2 Q_j(z),   l[j] = Re ∫ P_j log(z-t) dt,
///   d[j] = ∫ P_j/(z-t)² dt = -2 Q_j'(z)
///
/// Relative error about 1e-15 for j <= 2 and 1e-13 for j <= 25, from 1e-12 off the
/// element or its ends to |z| = 1e6.
struct LegendreMoments {
  std::array<Complex, largestDegree + 3> c{};
  std::array<Complex, largestDegree + 2> d{};
  std::array<double, largestDegree + 2> l{};
};

enum class Need { C, CandL, CandD, All };

/// The moments for j = 0 ... degree (degree <= largestDegree).  d is left alone on the
/// element, where ∫ P_j/(z-t)² does not exist.
void evaluateMoments(const RelativeTarget& target, int degree, Need need,
                     LegendreMoments& moments);

}  // namespace epafi::bem
