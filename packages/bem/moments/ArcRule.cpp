#include "bem/moments/ArcRule.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/MadeOnce.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// Terms by which 1/g falls below 1e-15: its poles are the places of the target on other
/// turns of the circle, farther than π/α.
int termsOfFactor(double alpha) {
  constexpr double digits = 35;
  return alpha == 0
             ? 1
             : static_cast<int>(digits / std::acosh(3.14159 / std::abs(alpha))) + 2;
}

/// Table[q * n + k] = (k + 1/2) w_q P_k(t_q) of the rule with n points.
Vector coefficientTable(int n) {
  const Rule& rule = gaussLegendre(n);
  Vector table(static_cast<std::size_t>(n * n));
  for (int q = 0; q < n; ++q) {
    double* row = table.data() + q * n;
    legendreValues(n - 1, rule.points[q], row);
    for (int k = 0; k < n; ++k)
      row[k] *= (k + 0.5) * rule.weights[q];
  }
  return table;
}

const Vector& coefficients(int n) {
  static MadeOnce<Vector, ArcRule::largestSize> tables(coefficientTable);
  return tables[n];
}

/// sin(s)/s by its series where |s| < 1/2.
EPAFI_INLINE ComplexPack shortSinc(const ComplexPack& s) {
  const ComplexPack square = s * s;
  const ComplexPack one{Pack{} + 1.0, Pack{}};
  ComplexPack sum = one;
#pragma GCC unroll 8
  for (int k = 7; k >= 1; --k)
    sum = one + (-1.0 / (2 * k * (2 * k + 1))) * (square * sum);
  return sum;
}

/// Parts 1: on the arc or its continuation, b = 0.
template <int Parts>
struct ArcKernel {
  const ArcRule& rule;
  const TargetLanes& x;
  KernelLanes* weights;

  template <Division>
  // NOLINTNEXTLINE(readability-function-*): one formula, in order
  EPAFI_INLINE void run() const {
    const int n = rule.size();
    const double alpha = 0.5 * rule.curve().angle();
    // e^{iA} and A = α conj(z)/2
    ComplexLanes turn{};
    for (int lane = 0; lane < lanes; ++lane)
      turn.set(lane,
               std::exp(Complex(0.5 * alpha * x.z.im[lane], 0.5 * alpha * x.z.re[lane])));
    const ComplexPack place = (0.5 * alpha) * conj(x.z);
    const ComplexPack there = turn.load();
    Pack squareOfThere;
    squareOf(there, squareOfThere);
    const ComplexPack back = (1.0 / squareOfThere) * conj(there);
    const ComplexPack sine = Complex(0, -0.5) * (there - back);
    const ComplexPack cosine = 0.5 * (there + back);
    // So far off that the Gauss rule itself does: error R^-(2n - degree).
    constexpr double digits = 37;
    const double limit = std::max(1.5, std::cosh(digits / (2 * n - rule.degree())));
    int far = 0;
    Pack isFar{};  // 1 where
    for (int lane = 0; lane < lanes; ++lane)
      if (0.5 * (std::hypot(x.zMinus1.re[lane], x.z.im[lane]) +
                 std::hypot(x.zPlus1.re[lane], x.z.im[lane])) >
          limit) {
        isFar[lane] = 1;
        ++far;
      }
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
    LegendreLanes<Parts, ArcRule::largestSize> legendre;
    if (far < lanes)
      legendre.evaluate(x, n);
    ComplexPack cubics[ArcRule::largestSize];
    for (int k = 0; k < n && far < lanes; ++k)
      cubics[k] = legendre.cubic(x, k);
    const double* row = coefficients(n).data();
    for (int q = 0; q < n; ++q, row += n) {
      const double weight = rule.weight(q);
      ComplexPack first;  // of f/(z-t)
      ComplexPack cubic;  // of f/(z-t) - 2ib f/(z-t)²
      Pack log{};
      for (int k = 0; k < n && far < lanes; ++k) {
        first = first + row[k] * legendre.at(k);
        cubic = cubic + row[k] * cubics[k];
        log += row[k] * legendre.l[k];
      }
      if (far > 0) {
        const ComplexPack difference{x.z.re - rule.point(q), x.z.im};
        Pack square;
        squareOf(difference, square);
        const ComplexPack inverse = (1.0 / square) * conj(difference);
        Pack logOfSquare;
        logarithm(square, logOfSquare);
        const auto chosen = isFar > 0.5;
        const ComplexPack direct = weight * inverse;
        const ComplexPack turned =
            direct + Complex(0, -2) * (x.z.im * (direct * inverse));
        first = {chosen ? direct.re : first.re, chosen ? direct.im : first.im};
        cubic = {chosen ? turned.re : cubic.re, chosen ? turned.im : cubic.im};
        log = chosen ? (0.5 * weight) * logOfSquare : log;
      }
      // g = half τ e^{i(A+B)} sinc(A-B),  B = α t/2
      const double angle = 0.5 * alpha * rule.point(q);
      const ComplexPack s{place.re - angle, place.im};
      Pack size;
      squareOf(s, size);
      const ComplexPack series = shortSinc(s);
      const ComplexPack sum =
          (1.0 / size) * (conj(s) * (std::cos(angle) * sine - std::sin(angle) * cosine));
      const auto isShort = size < 0.25;
      const ComplexPack sinc{isShort ? series.re : sum.re, isShort ? series.im : sum.im};
      const ComplexPack g =
          (rule.curve().half() * asComplex(rule.curve().frame().tangent) *
           Complex(std::cos(angle), std::sin(angle))) *
          (there * sinc);
      Pack square;
      squareOf(g, square);
      const ComplexPack inverse = (1.0 / square) * g;  // 1/conj(g)
      Pack logOfSquare;
      logarithm(square, logOfSquare);
      const double half = rule.curve().half();
      KernelLanes& to = weights[q];
      to.overConj.store(half * (first * inverse));
      to.cubic.store(half * (cubic * g * inverse * inverse));
      const ComplexPack turning{weight + 2.0 * x.z.im * first.im,
                                -2.0 * x.z.im * first.re};
      to.phase.store(half * (turning * g * inverse));
      store(to.log.lane, half * (log + (0.5 * weight) * logOfSquare));
    }
  }
};

}  // namespace

ArcRule::ArcRule(const Curve& curve, int degree) : curve_(curve), degree_(degree) {
  if (std::abs(curve.angle()) > largestAngle)
    throw InputError("an element turns by more than half a circle");
  const int terms = degree + termsOfFactor(0.5 * curve.angle());
  rule_ = &gaussLegendre(std::min(terms, largestSize));
  legendre_.resize(at(size(), 0));
  for (int q = 0; q < size(); ++q) {
    legendreValues(degree, point(q), legendre_.data() + at(q, 0));
    tangents_.push_back(asComplex(curve.tangent(point(q))));
  }
}

void ArcRule::evaluate(const TargetLanes& x, KernelLanes* weights) const {
  if (areOnLine(x))
    dispatch(ArcKernel<1>{*this, x, weights});
  else
    dispatch(ArcKernel<2>{*this, x, weights});
}

}  // namespace epafi::bem
