#pragma once

#include "bem/moments/FarOrder.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/Pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// LegendreMoments of eight targets at once, which lie on a straight line.

namespace epafi::bem {

/// Eight points of an element from the first on; where there are fewer, the first again.
struct PointLanes {
  alignas(64) double t[lanes];
  alignas(64) double fromStart[lanes];
  alignas(64) double toEnd[lanes];

  EPAFI_INLINE PointLanes(const std::vector<EndPoint>& points, std::size_t first) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const EndPoint& point = points[first + lane < points.size() ? first + lane : first];
      t[lane] = point.t;
      fromStart[lane] = point.fromStart;
      toEnd[lane] = point.toEnd;
    }
  }
};

/// Targets z = a + ib as in RelativeTarget.
struct TargetLanes {
  Pack z;
  Pack minus;  ///< a - 1
  Pack plus;   ///< a + 1
  Pack b;

  EPAFI_INLINE TargetLanes(const Sight& s, const PointLanes& points) {
    const Pack fromStart = load(points.fromStart);
    const Pack toEnd = load(points.toEnd);
    const Pack zero{};
    const auto atStart = fromStart < toEnd;
    const Pack along = atStart ? fromStart : -toEnd;
    const auto from = [&](const Complex& start, const Complex& end, Pack& x, Pack& y) {
      x = (atStart ? zero + start.real() : zero + end.real()) + s.step.real() * along;
      y = (atStart ? zero + start.imag() : zero + end.imag()) + s.step.imag() * along;
    };
    Pack bOfPlus;
    from(s.start.zMinus1, s.end.zMinus1, minus, b);
    from(s.start.zPlus1, s.end.zPlus1, plus, bOfPlus);
    // both from the offset to the nearer end
    const auto atOne = minus * minus + b * b < plus * plus + bOfPlus * bOfPlus;
    z = atOne ? 1.0 + minus : plus - 1.0;
    const Pack other = atOne ? minus + 2.0 : plus;
    minus = atOne ? minus : plus - 2.0;
    plus = other;
    b = atOne ? b : bOfPlus;
  }
};

/// 2 Q_j and Re ∫ P_j log(z-t) dt of eight targets; Parts 1: on the element's line, where
/// all is real.
template <int Parts>
struct LegendreLanes {
  static constexpr int size = largestMoment + 1;
  Pack c[Parts][size];
  Pack l[size];

  EPAFI_INLINE void evaluate(const TargetLanes& x, int top) {
    const Pack minus2 = x.minus * x.minus + x.b * x.b;
    const Pack plus2 = x.plus * x.plus + x.b * x.b;
    Pack logMinus;
    Pack logPlus;
    logarithm(minus2, logMinus);
    logarithm(plus2, logPlus);
    c[0][0] = 0.5 * (logPlus - logMinus);
    l[0] = 0.5 * (logPlus + logMinus) - 2.0 + x.z * c[0][0];
    if constexpr (Parts == 2) {
      angle(2.0 * x.b, x.minus * x.plus + x.b * x.b, c[1][0]);
      c[1][0] = -c[1][0];
      l[0] -= x.b * c[1][0];
    }
    if (top == 0)
      return;
    Pack distanceMinus;
    Pack distancePlus;
    squareRoot(minus2, distanceMinus);
    squareRoot(plus2, distancePlus);
    const Pack focal = distanceMinus + distancePlus;
    // The forward recurrence loses R = |z + √(z-1) √(z+1)| a step: one digit in all is what
    // moments of size 1 can spare.  R + 1/R is the sum of distances.
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
      LegendreLanes other;
      other.backward(x, top, std::acosh(0.5 * nearest), *this);
      const auto isFar = focal > limit;
      for (int part = 0; part < Parts; ++part)
        for (int j = 1; j <= top; ++j)
          c[part][j] = isFar ? other.c[part][j] : c[part][j];
    }
    for (int j = 1; j < top; ++j)
      l[j] = (c[0][j + 1] - c[0][j - 1]) * (1.0 / (2 * j + 1));
  }

 private:
  EPAFI_INLINE void forward(const TargetLanes& x, int top) {
    c[0][1] = x.z * c[0][0] - 2.0;
    if constexpr (Parts == 2) {
      c[0][1] -= x.b * c[1][0];
      c[1][1] = x.z * c[1][0] + x.b * c[0][0];
    }
    for (int j = 1; j < top; ++j) {
      const double here = (2 * j + 1.0) / (j + 1);
      const double before = j / (j + 1.0);
      Pack real = x.z * c[0][j];
      if constexpr (Parts == 2) {
        real -= x.b * c[1][j];
        c[1][j + 1] = here * (x.z * c[1][j] + x.b * c[0][j]) - before * c[1][j - 1];
      }
      c[0][j + 1] = here * real - before * c[0][j - 1];
    }
  }

  // Miller's recurrence, scaled to 2 Q₀: from where R^-2 a step has left 1e-16 of it.  It
  // is kept near 1 until the first value that is wanted.
  EPAFI_INLINE void backward(const TargetLanes& x, int top, double logR,
                             const LegendreLanes& first) {
    Pack above[2] = {};
    Pack here[2] = {Pack{} + 1.0, Pack{}};
    const int start = std::max(top, static_cast<int>(18.5 / logR + 0.5 * top)) + 2;
    for (int j = start; j > 0; --j) {
      const double inverse = 1.0 / j;
      Pack real = x.z * here[0];
      if constexpr (Parts == 2) {
        real -= x.b * here[1];
        const Pack imag = x.z * here[1] + x.b * here[0];
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
      } else if (j % 16 == 0) {
        const Pack scale = 1.0 / (here[0] * here[0] + here[1] * here[1]);
        Pack root;
        squareRoot(scale, root);
        for (int part = 0; part < Parts; ++part) {
          here[part] *= root;
          above[part] *= root;
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
