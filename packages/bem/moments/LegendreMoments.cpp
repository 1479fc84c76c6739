#include "bem/moments/LegendreMoments.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

// Re Q₀(z) = log |(z+1)/(z-1)| / 2 without the cancellation of the quotient far away.
double realQ0(const RelativeTarget& x) {
  const double a = x.z().real();
  return a >= 0 ? 0.25 * std::log1p(4 * a / std::norm(x.zMinus1))
                : -0.25 * std::log1p(-4 * a / std::norm(x.zPlus1));
}

Complex legendreQ0(const RelativeTarget& x) {
  const double product = x.zMinus1.real() * x.zPlus1.real() + x.b() * x.b();
  return {realQ0(x), -0.5 * std::atan2(2 * x.b(), product)};
}

// 2 Q_j for j = 0 ... top by the forward recurrence, stable near [-1, 1].
template <class Number>
void forward(Number z, Number q0, int top, Number* c) {
  c[0] = 2.0 * q0;
  if (top > 0)
    c[1] = z * c[0] - 2.0;
  for (int j = 1; j < top; ++j)
    c[j + 1] = ((2 * j + 1.0) * z * c[j] - static_cast<double>(j) * c[j - 1]) / (j + 1.0);
}

// 2 Q_j for j = 0 ... top by Miller's backward recurrence, scaled to 2 Q₀.  Values grow
// by R a step, from a start so small that even |z| = 1e10 with top = 25 ends below 1e150.
template <class Number>
void backward(Number z, Number q0, int top, double logR, Number* c) {
  const int start = top + static_cast<int>(37 / (2 * logR)) + 2;
  Number above = 0;
  Number here = 1e-150;
  for (int j = start; j > 0; --j) {
    const double inverse = 1.0 / j;
    const Number below = (2 + inverse) * (z * here) - (1 + inverse) * above;
    above = here;
    here = below;
    if (j - 1 <= top)
      c[j - 1] = here;
  }
  const Number scale = 2.0 * q0 / c[0];
  for (int j = 0; j <= top; ++j)
    c[j] *= scale;
}

// The forward recurrence loses R² a step.
bool isForwardStable(int top, double logR) { return 2 * top * logR < 2.3; }

/// A target in real numbers on the element's line, else in complex ones.
template <class Number>
struct Target {
  Number z;
  Number zMinus1;
  Number zPlus1;
};

/// log |z + √(z-1) √(z+1)|.
double logRadius(const Target<Complex>& x) {
  return std::log(std::abs(x.z + std::sqrt(x.zMinus1) * std::sqrt(x.zPlus1)));
}
double logRadius(const Target<double>& x) {
  const double product = x.zMinus1 * x.zPlus1;
  return product > 0 ? std::log(std::abs(x.z) + std::sqrt(product)) : 0;
}

/// d[0] ... d[degree], unless the target lies on the element.
template <class Number, class Moments>
void derivatives(const Target<Number>& x, const Number* c, int degree, bool ranForward,
                 Moments& m) {
  if (!ranForward) {
    const Number scale = -1.0 / (x.zMinus1 * x.zPlus1);
    for (int j = 0; j <= degree; ++j)
      m.d[j] = scale * (j + 1.0) * (c[j + 1] - x.z * c[j]);
    return;
  }
  const Number left = 1.0 / x.zPlus1;
  const Number right = 1.0 / x.zMinus1;
  // D_j = 1/(z-1) - (-1)^j/(z+1) - Σ (2k+1) C_k over k = j-1, j-3, ...
  Number sum[2] = {0, 0};
  for (int j = 0; j <= degree; ++j) {
    m.d[j] = right - (j % 2 == 0 ? left : -left) - sum[j % 2];
    sum[(j + 1) % 2] += (2 * j + 1.0) * c[j];
  }
}

template <class Number, class Moments>
void evaluate(const Target<Number>& x, Number q0, bool onElement, int degree, Need need,
              Moments& m) {
  const bool wantL = need != Need::CandD;
  const bool wantD = need != Need::CandL && !onElement;
  Number c[Moments::longest + 2] = {};
  if (degree == 0) {
    c[0] = 2.0 * q0;
    if (wantD)
      m.d[0] = 2.0 / (x.zMinus1 * x.zPlus1);
  } else {
    const int top = degree + 1;
    const double logR = logRadius(x);
    const bool runForward = isForwardStable(top, logR);
    if (runForward)
      forward(x.z, q0, top, c);
    else
      backward(x.z, q0, top, logR, c);
    if (wantD)
      derivatives(x, c, degree, runForward, m);
  }
  for (int j = 0; j <= degree; ++j)
    m.c[j] = c[j];
  if (!wantL)
    return;
  m.l[0] = std::log(std::abs(x.zMinus1 * x.zPlus1)) + std::real(x.z * c[0]) - 2;
  for (int j = 1; j <= degree; ++j)
    m.l[j] = std::real(c[j + 1] - c[j - 1]) / (2 * j + 1);
}

template <class Moments>
void evaluateAny(const RelativeTarget& x, int degree, Need need, Moments& m) {
  if (x.b() == 0)
    evaluate(Target<double>{x.z().real(), x.zMinus1.real(), x.zPlus1.real()}, realQ0(x),
             x.onElement(), degree, need, m);
  else
    evaluate(Target<Complex>{x.z(), x.zMinus1, x.zPlus1}, legendreQ0(x), false, degree,
             need, m);
}

}  // namespace

void evaluateMoments(const RelativeTarget& x, int degree, Need need, LegendreMoments& m) {
  evaluateAny(x, degree, need, m);
}

void evaluateMoments(const RelativeTarget& x, int degree, Need need,
                     LongLegendreMoments& m) {
  evaluateAny(x, degree, need, m);
}

}  // namespace epafi::bem
