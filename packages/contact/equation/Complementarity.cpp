#include "contact/equation/Complementarity.hpp"

#include <cmath>

namespace epafi::contact {

Complementarity projectedNormal(double multiplier, double penetration) {
  if (multiplier + penetration > 0)
    return {-penetration, 0, -1, 0};
  return {multiplier, 1, 0, 0};
}

Complementarity projectedTangential(double multiplier, double slip, double bound) {
  const double trial = multiplier + slip;
  if (trial >= bound)
    return {multiplier - bound, 1, 0, -1};
  if (trial <= -bound)
    return {multiplier + bound, 1, 0, 1};
  return {-slip, 0, -1, 0};
}

namespace {

// φ(a,b) = a + b - √(a²+b²): zero exactly when a ≥ 0, b ≥ 0 and ab = 0.    [Fischer 1992]
struct Phi {
  double value;
  double a;
  double b;
};

// 1 - x/h for h = √(x²+y²) > 0, without cancellation.
double oneMinusCosine(double x, double y, double h) {
  return x > 0 ? (y / h) * (y / (h + x)) : 1 - x / h;
}

Phi fischer(double a, double b) {
  const double h = std::hypot(a, b);
  if (std::isinf(a))
    return {b, 0, 1};
  if (h == 0) {
    const double slope = 1 - std::sqrt(0.5);  // the limit along a = b > 0
    return {0, slope, slope};
  }
  const double value = a + b > 0 ? 2 * a * (b / (a + b + h)) : a + b - h;
  return {value, oneMinusCosine(a, b, h), oneMinusCosine(b, a, h)};
}

}  // namespace

Complementarity fischerNormal(double multiplier, double penetration) {
  const Phi phi = fischer(multiplier, -penetration);
  return {phi.value, phi.a, -phi.b, 0};
}

// φ(λ + s, -φ(s - λ, y)): the inner φ is for the upper bound, the outer one for the lower.
// [Billups 1995]  At the kink of the inner φ (λ = s, y = 0) the outer one is zero, so that
// its square is continuously differentiable.
Complementarity fischerTangential(double multiplier, double slip, double bound) {
  const Phi upper = fischer(bound - multiplier, slip);
  const Phi both = fischer(multiplier + bound, -upper.value);
  return {both.value, both.a + both.b * upper.a, -both.b * upper.b,
          both.a - both.b * upper.a};
}

}  // namespace epafi::contact
