#pragma once

#include "bem/moments/Nearness.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

/// Integrals over [-1, 1] of Legendre polynomials times factors of the kernels, in closed form
/// by Legendre functions of the second kind Q_j.               [doc/theory/operators.md]
///
///   c[j] = ∫ P_j/(z-t) dt = 2 Q_j(z),  j <= top,    l[j] = Re ∫ P_j log(z-t) dt,  j < top
///
/// Absolute error 1e-15 for low degrees, else 1e-14.  Parts = 1: targets on the line of the
/// element, where all values are real.
template <int Parts, int Longest = largestMoment>
struct LegendreLanes {
  static constexpr int size = Longest + 1;
  Pack c[Parts][size];
  Pack l[size];

  EPAFI_INLINE void evaluate(const TargetLanes& x, int top) {
    const Pack minus2 = x.zMinus1.re * x.zMinus1.re + x.z.im * x.z.im;
    const Pack plus2 = x.zPlus1.re * x.zPlus1.re + x.z.im * x.z.im;
    Pack logMinus;
    Pack logPlus;
    logarithm(minus2, logMinus);
    logarithm(plus2, logPlus);
    c[0][0] = 0.5 * (logPlus - logMinus);
    l[0] = 0.5 * (logPlus + logMinus) - 2.0 + x.z.re * c[0][0];
    if constexpr (Parts == 2) {
      angle(2.0 * x.z.im, x.zMinus1.re * x.zPlus1.re + x.z.im * x.z.im, c[1][0]);
      c[1][0] = -c[1][0];
      l[0] -= x.z.im * c[1][0];
    }
    if (top == 0)
      return;
    Pack distanceMinus;
    Pack distancePlus;
    squareRoot(minus2, distanceMinus);
    squareRoot(plus2, distancePlus);
    const Pack focal = distanceMinus + distancePlus;
    // A step of the forward recurrence amplifies errors by R = |z + √(z-1) √(z+1)|.  A loss of one
    // digit in total is acceptable for moments of size 1.  R + 1/R is the sum of distances.
    const double limit = 2 * std::cosh(std::log(10.0) / top);
    double nearest = std::numeric_limits<double>::infinity();
    int count = 0;
    for (int lane = 0; lane < lanes; ++lane)
      if (focal[lane] > limit) {
        nearest = std::min(nearest, focal[lane]);
        ++count;
      }
    if (count < lanes)
      forward(x, top);
    if (count > 0) {
      LegendreLanes other;  // NOLINT(cppcoreguidelines-pro-type-member-init)
      other.backward(x, top, std::acosh(0.5 * nearest), *this);
      const auto isFar = focal > limit;
      for (int part = 0; part < Parts; ++part)
        for (int j = 1; j <= top; ++j)
          c[part][j] = isFar ? other.c[part][j] : c[part][j];
    }
    for (int j = 1; j < top; ++j)
      l[j] = (c[0][j + 1] - c[0][j - 1]) * (1.0 / (2 * j + 1));
  }

  EPAFI_INLINE ComplexPack at(int j) const {
    if constexpr (Parts == 1)
      return {c[0][j], Pack{}};
    else
      return {c[0][j], c[1][j]};
  }
  /// ∫ P_j (1/(z-t) - 2ib/(z-t)²) dt, j < top:  (1 - z²) ∫ P_j/(z-t)² = (j+1) (C_{j+1} - z C_j).
  /// On the line b = 0, and the second part need not exist.
  EPAFI_INLINE ComplexPack cubic(const TargetLanes& x, int j) const {
    if constexpr (Parts == 1)
      return at(j);
    const Pack real = x.zMinus1.re * x.zPlus1.re - x.z.im * x.z.im;  // of z² - 1
    const Pack imag = x.z.im * (x.zMinus1.re + x.zPlus1.re);
    const Pack scale = 2.0 * x.z.im / (real * real + imag * imag);
    const ComplexPack factor{scale * imag, scale * real};  // 2ib / (z² - 1)
    return at(j) + (j + 1.0) * (factor * (at(j + 1) - x.z * at(j)));
  }

 private:
  EPAFI_INLINE void forward(const TargetLanes& x, int top) {
    c[0][1] = x.z.re * c[0][0] - 2.0;
    if constexpr (Parts == 2) {
      c[0][1] -= x.z.im * c[1][0];
      c[1][1] = x.z.re * c[1][0] + x.z.im * c[0][0];
    }
    for (int j = 1; j < top; ++j) {
      const double here = (2 * j + 1.0) / (j + 1);
      const double before = j / (j + 1.0);
      Pack real = x.z.re * c[0][j];
      if constexpr (Parts == 2) {
        real -= x.z.im * c[1][j];
        c[1][j + 1] = here * (x.z.re * c[1][j] + x.z.im * c[0][j]) - before * c[1][j - 1];
      }
      c[0][j + 1] = here * real - before * c[0][j - 1];
    }
  }

  // Miller's backward recurrence, scaled to 2 Q₀.  Errors decay by R^-2 a step; it starts where
  // they decay to 1e-16.  Values are kept near 1 until the first one that is stored, and behind it
  // where a target is so far away that they would overflow: the first ones are as good as zero then.
  EPAFI_INLINE void backward(const TargetLanes& x, int top, double logR,
                             const LegendreLanes& first) {
    Pack above[2] = {};
    Pack here[2] = {Pack{} + 1.0, Pack{}};
    const int start = std::max(top, static_cast<int>(18.5 / logR + 0.5 * top)) + 2;
    double farthest = 1;
    for (int lane = 0; lane < lanes; ++lane)
      farthest = std::max(farthest, std::abs(x.z.re[lane]) + std::abs(x.z.im[lane]));
    const bool overflows = start * std::log(2 * farthest) > 230;  // e^230 = 1e100
    for (int j = start; j > 0; --j) {
      const double inverse = 1.0 / j;
      Pack real = x.z.re * here[0];
      if constexpr (Parts == 2) {
        real -= x.z.im * here[1];
        const Pack imag = x.z.re * here[1] + x.z.im * here[0];
        const Pack below = (2 + inverse) * imag - (1 + inverse) * above[1];
        above[1] = here[1];
        here[1] = below;
      }
      const Pack below = (2 + inverse) * real - (1 + inverse) * above[0];
      above[0] = here[0];
      here[0] = below;
      if (j - 1 <= top) {
        for (int part = 0; part < Parts; ++part)
          c[part][j - 1] = here[part];
      }
      if (overflows ? j % 4 == 0 : j - 1 > top && j % 16 == 0) {
        const Pack scale = 1.0 / (here[0] * here[0] + here[1] * here[1]);
        Pack root;
        squareRoot(scale, root);
        for (int part = 0; part < Parts; ++part) {
          here[part] *= root;
          above[part] *= root;
          for (int k = j - 1; k <= top; ++k)
            c[part][k] *= root;
        }
      }
    }
    Pack norm = c[0][0] * c[0][0];
    Pack real = first.c[0][0] * c[0][0];
    Pack imag{};
    if constexpr (Parts == 2) {
      norm += c[1][0] * c[1][0];
      real += first.c[1][0] * c[1][0];
      imag = first.c[1][0] * c[0][0] - first.c[0][0] * c[1][0];
    }
    const Pack inverse = 1.0 / norm;
    real *= inverse;
    imag *= inverse;
    for (int j = 0; j <= top; ++j) {
      const Pack value = c[0][j];
      c[0][j] = real * value;
      if constexpr (Parts == 2) {
        c[0][j] -= imag * c[1][j];
        c[1][j] = real * c[1][j] + imag * value;
      }
    }
  }
};

}  // namespace epafi::bem
