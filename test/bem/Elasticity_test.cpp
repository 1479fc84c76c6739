// Kelvin's kernels: each is what elasticity says of the one before.
#include "bem/kernel/Elasticity.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using bem::Complex;
using bem::SourceSums;

const bem::Lame lame({1, 0.3, false});
const Complex place(0.3, -0.2);    // of the source
const Complex target(-0.5, 0.45);  // of the point that sees it
const Complex force(0.7, 0.4);
const Complex normal = std::polar(1.0, 0.6);
constexpr double step = 1e-3;

SourceSums seen(Complex x, Complex g) {
  const Complex w = x - place;
  return {g / w, g / std::conj(w), std::conj(g) * w / std::conj(w * w)};
}

Complex potential(const bem::Lame& constants, Complex x, Complex f) {
  const Complex w = x - place;
  return bem::singleLayer(constants, std::log(std::abs(w)) * f, f,
                          std::conj(f) * w / std::conj(w));
}

/// Derivative at `target` in a direction, to the fourth order of the step.
template <class Field>
Complex derivative(const Field& field, Complex direction) {
  const auto difference = [&](double s) {
    return (field(target + s * direction) - field(target - s * direction)) / (2 * s);
  };
  return (4.0 * difference(step) - difference(2 * step)) / 3.0;
}

}  // namespace

TEUCHOS_UNIT_TEST(Elasticity, constantsFollowTheReferenceStress) {
  const bem::Material material{8, 0.3, true};
  const bem::Lame own(material);
  const bem::Lame shared(material, 2);  // four times as stiff as the reference
  TEST_FLOATING_EQUALITY(shared.mu, 4 * own.mu, 1e-15);
  TEST_FLOATING_EQUALITY(shared.d, 4 * own.d, 1e-15);
  TEST_FLOATING_EQUALITY(4 * shared.a, own.a, 1e-15);
  TEST_FLOATING_EQUALITY(4 * shared.b, own.b, 1e-15);
  const double pi = std::acos(-1.0);
  TEST_FLOATING_EQUALITY(2 * pi * shared.mu * (shared.a + shared.b), 1.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Elasticity, singleLayerIsKelvinsSolution) {
  const Complex w = target - place;
  const double r = std::abs(w);
  const Complex d = w / r;
  const Complex exact = -lame.a * std::log(r) * force +
                        lame.b * d * std::real(std::conj(d) * force);  // B d (d·f)
  TEST_COMPARE(std::abs(potential(lame, target, force) - exact), <, 1e-15);

  const bem::Block block =
      bem::singleLayerBlock(lame.a, lame.b, std::log(r), w / std::conj(w), 1);
  const Complex product(block.xx * force.real() + block.xy * force.imag(),
                        block.yx * force.real() + block.yy * force.imag());
  TEST_COMPARE(std::abs(product - exact), <, 1e-15);
}

TEUCHOS_UNIT_TEST(Elasticity, adjointDoubleLayerIsItsTraction) {
  const auto u = [](Complex x) { return potential(lame, x, force); };
  const Complex dx = derivative(u, 1);
  const Complex dy = derivative(u, Complex(0, 1));
  const double trace = dx.real() + dy.imag();
  const double lambda = 2 * lame.mu * lame.nu / (1 - 2 * lame.nu);
  const double xx = lambda * trace + 2 * lame.mu * dx.real();
  const double yy = lambda * trace + 2 * lame.mu * dy.imag();
  const double xy = lame.mu * (dx.imag() + dy.real());
  const Complex traction(xx * normal.real() + xy * normal.imag(),
                         xy * normal.real() + yy * normal.imag());
  const Complex value = bem::adjointDoubleLayer(lame, normal, seen(target, force));
  TEST_COMPARE(std::abs(value - traction), <, 1e-10);
}

TEUCHOS_UNIT_TEST(Elasticity, doubleLayerIsTheAdjointOfTheAdjoint) {
  const Complex v(-0.2, 0.9);
  const Complex onPlane = bem::doubleLayer(
      lame, seen(target, normal * v), seen(target, std::real(std::conj(normal) * v)));
  const Complex w = place - target;  // the two places exchanged
  const SourceSums back = {force / w, force / std::conj(w),
                           std::conj(force) * w / std::conj(w * w)};
  const Complex traction = bem::adjointDoubleLayer(lame, normal, back);
  TEST_COMPARE(std::abs(std::real(std::conj(force) * onPlane) -
                        std::real(std::conj(v) * traction)),
               <, 1e-15);
}

TEUCHOS_UNIT_TEST(Elasticity, slopesAreDerivativesAlongTheTangent) {
  const Complex tangent = Complex(0, 1) * normal;
  const auto u = [](Complex x) { return potential(lame, x, force); };
  const Complex slope = bem::singleLayerSlope(lame, normal, seen(target, force));
  TEST_COMPARE(std::abs(slope - derivative(u, tangent)), <, 1e-10);

  bem::Lame star = lame;  // W u = -d/ds V* u'
  star.a = star.b = lame.d;
  const auto v = [&](Complex x) { return potential(star, x, force); };
  const Complex w = bem::hypersingular(lame, normal, seen(target, force));
  TEST_COMPARE(std::abs(w + derivative(v, tangent)), <, 1e-10);
}

TEUCHOS_UNIT_TEST(Elasticity, doubleLayerBlockIsTheDoubleLayerByParts) {
  // a smooth hump that vanishes at both ends, so that the trapezoidal rule is exact
  const Complex y0(-0.1, -0.3);
  const Complex tangent = std::polar(1.0, 0.25);
  const Complex n = Complex(0, -1) * tangent;
  const int points = 2000;
  Complex direct = 0;
  double log = 0;
  Complex phase = 0;
  double laplace = 0;
  for (int q = 0; q < points; ++q) {
    const double s = (q + 0.5) / points;
    const Complex w = target - (y0 + s * tangent);
    const double v = std::pow(s * (1 - s), 4);
    const double slope = 4 * std::pow(s * (1 - s), 3) * (1 - 2 * s);
    const auto sums = [&](Complex g) {
      return SourceSums{g / w, g / std::conj(w), std::conj(g) * w / std::conj(w * w)};
    };
    direct += bem::doubleLayer(lame, sums(n * v * force),
                               sums(std::real(std::conj(n) * v * force))) /
              static_cast<double>(points);
    log += slope * std::log(std::abs(w)) / points;
    phase += slope / points * (w / std::conj(w));
    laplace += v * std::real(std::conj(n) * w) / std::norm(w) / points;
  }
  const bem::Block block = bem::doubleLayerBlock(lame, log, phase, laplace);
  const Complex byParts(block.xx * force.real() + block.xy * force.imag(),
                        block.yx * force.real() + block.yy * force.imag());
  TEST_COMPARE(std::abs(direct), >, 1e-4);
  TEST_COMPARE(std::abs(direct - byParts), <, 1e-12);
}

}  // namespace epafi
