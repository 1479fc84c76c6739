#include "bem/potential/LegendreMoments.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

// Q₀(z) = log((z+1)/(z-1)) / 2 without the cancellation of the quotient far away.
Complex legendreQ0(const RelativeTarget& x, bool onElement) {
  const double a = x.z().real();
  const double real = a >= 0 ? 0.25 * std::log1p(4 * a / std::norm(x.zMinus1))
                             : -0.25 * std::log1p(-4 * a / std::norm(x.zPlus1));
  if (onElement)
    return real;
  const double product = x.zMinus1.real() * x.zPlus1.real() + x.b() * x.b();
  return {real, -0.5 * std::atan2(2 * x.b(), product)};
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

}  // namespace

LogMoments logMomentsAhead(double gap, int degree) {
  LogMoments l{};
  std::array<double, largestDegree + 3> c{};
  const double z = 1 + gap;
  const double product = gap * (gap + 2);
  const double q0 = 0.5 * std::log1p(2 / gap);
  const int top = degree == 0 ? 0 : degree + 1;
  const double logR = top == 0 ? 0 : std::log(z + std::sqrt(product));
  if (isForwardStable(top, logR))
    forward(z, q0, top, c.data());
  else
    backward(z, q0, top, logR, c.data());
  l[0] = std::log(product) + z * c[0] - 2;
  for (int j = 1; j <= degree; ++j)
    l[j] = (c[j + 1] - c[j - 1]) / (2 * j + 1);
  return l;
}

void evaluateMoments(const RelativeTarget& x, int degree, Need need, LegendreMoments& m) {
  const bool onElement = x.onElement();
  const bool wantL = need == Need::CandL || need == Need::All;
  const bool wantD = (need == Need::CandD || need == Need::All) && !onElement;
  const int top = need == Need::C ? degree : degree + 1;
  const Complex z = x.z();
  const Complex q0 = legendreQ0(x, onElement);

  const double radius = std::abs(z + std::sqrt(x.zMinus1) * std::sqrt(x.zPlus1));
  const double logR = std::log(radius);
  const bool runForward = isForwardStable(top, logR);
  if (runForward)
    forward(z, q0, top, m.c.data());
  else
    backward(z, q0, top, logR, m.c.data());

  if (wantL) {
    m.l[0] = 0.5 * std::log(std::norm(x.zMinus1) * std::norm(x.zPlus1)) +
             (z * m.c[0]).real() - 2;
    for (int j = 1; j <= degree; ++j)
      m.l[j] = (m.c[j + 1].real() - m.c[j - 1].real()) / (2 * j + 1);
  }
  if (!wantD)
    return;
  const Complex product = x.zMinus1 * x.zPlus1;
  if (runForward) {
    const Complex left = 1.0 / x.zPlus1;
    const Complex right = 1.0 / x.zMinus1;
    // D_j = 1/(z-1) - (-1)^j/(z+1) - Σ (2k+1) C_k over k = j-1, j-3, ...
    Complex sum[2] = {0, 0};
    for (int j = 0; j <= degree; ++j) {
      m.d[j] = right - (j % 2 == 0 ? left : -left) - sum[j % 2];
      sum[(j + 1) % 2] += (2 * j + 1.0) * m.c[j];
    }
  } else {
    for (int j = 0; j <= degree; ++j)
      m.d[j] = -(j + 1.0) * (m.c[j + 1] - z * m.c[j]) / product;
  }
}

}  // namespace epafi::bem
