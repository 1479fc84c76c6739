#include "reference/QuadOperators.hpp"

#include "reference/SampleMeshes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi::reference {

namespace {

constexpr int degree = 10;

const PairIntegrator& integrator() {
  static const PairIntegrator instance(degree, 1e-22);
  return instance;
}

/// Largest difference of two tables, relative to the largest entry of the same field.
double difference(const PairMoments& a, const PairMoments& b) {
  double worst = 0;
  for (int f = 0; f < fields; ++f) {
    Quad error = 0;
    Quad size = 0;
    for (int i = 0; i <= a.firstDegree(); ++i)
      for (int j = 0; j <= a.secondDegree(); ++j) {
        const auto field = static_cast<Field>(f);
        error = std::max<Quad>(error, abs(a(field, i, j) - b(field, i, j)));
        size = std::max<Quad>(size, abs(b(field, i, j)));
      }
    if (size > 0)
      worst = std::max(worst, static_cast<double>(error / size));
  }
  return worst;
}

PairMoments plus(PairMoments a, const PairMoments& b) {
  for (int f = 0; f < fields; ++f)
    for (int i = 0; i <= a.firstDegree(); ++i)
      for (int j = 0; j <= a.secondDegree(); ++j)
        a(static_cast<Field>(f), i, j) += b(static_cast<Field>(f), i, j);
  return a;
}

QuadCurve fromVertex(double angleInDegrees, double length) {
  const double angle = angleInDegrees * std::acos(-1.0) / 180;
  return segment({0, 0}, {length * std::cos(angle), length * std::sin(angle)});
}

/// From one fraction of a segment to another.
QuadCurve part(const QuadCurve& s, double from, double to) {
  return segment(s.point(2 * from - 1), s.point(2 * to - 1));
}

TEUCHOS_UNIT_TEST(QuadMoments, gaussRuleIntegratesMonomialsTo30Digits) {
  for (int n : {1, 2, 7, 30}) {
    const QuadRule rule = quadGauss(n);
    for (int k = 0; k < 2 * n; ++k) {
      Quad sum = k % 2 == 0 ? -Quad(2) / (k + 1) : Quad(0);
      for (int q = 0; q < n; ++q)
        sum += rule.weights[q] * pow(rule.points[q], k);
      TEST_COMPARE(static_cast<double>(abs(sum)), <, 1e-30);
    }
  }
}

// ∫∫ log|s-t| = 4 log 2 - 6,  ∫∫ s t log|s-t| = -1,  ∫∫ t / (s-t) = -2 (principal value).
TEUCHOS_UNIT_TEST(QuadMoments, selfLogarithmHasItsClosedForm) {
  const QuadCurve unit = segment({-1, 0}, {1, 0});
  const PairMoments m = integrator()(unit, degree, unit, degree, Meeting::Same);
  TEST_COMPARE(static_cast<double>(abs(m(Field::LogR, 0, 0) - (4 * log(Quad(2)) - 6))), <,
               1e-30);
  TEST_COMPARE(static_cast<double>(abs(m(Field::LogR, 1, 1) + 1)), <, 1e-30);
  TEST_COMPARE(static_cast<double>(abs(m(Field::Xxx, 0, 1) + 2)), <, 1e-30);
}

// With P_0 on the part that is cut, self, touching and separated pairs must add up.
TEUCHOS_UNIT_TEST(QuadMoments, halvesAddUpToTheWholeElement) {
  const QuadCurve whole = fromVertex(17, 0.7);
  const QuadCurve left = part(whole, 0, 0.25);
  const QuadCurve right = part(whole, 0.25, 1);
  const PairMoments one = integrator()(whole, 0, whole, 0, Meeting::Same);
  const PairMoments inner = integrator()(left, 0, left, 0, Meeting::Same);
  const PairMoments outer = integrator()(right, 0, right, 0, Meeting::Same);
  const PairMoments mixed = integrator()(left, 0, right, 0, Meeting::ToFrom);
  const PairMoments sum = plus(plus(inner, outer), plus(mixed, mixed.transposed()));
  for (Field f : {Field::LogR, Field::Xx, Field::Xy})
    TEST_COMPARE(static_cast<double>(abs(sum(f, 0, 0) - one(f, 0, 0))), <, 1e-25);
}

TEUCHOS_UNIT_TEST(QuadMoments, touchingPairIsATouchingAndASeparatedPair) {
  for (double angle : {180.0, 90.0, 5.0, 300.0})
    for (double ratio : {1.0, 1e-3}) {
      const QuadCurve first = fromVertex(0, 1);
      const QuadCurve second = fromVertex(angle, ratio);
      const QuadCurve nearPart = part(second, 0, 0.375);
      const QuadCurve farPart = part(second, 0.375, 1);
      const PairMoments one = integrator()(first, degree, second, 0, Meeting::FromFrom);
      const PairMoments sum =
          plus(integrator()(first, degree, nearPart, 0, Meeting::FromFrom),
               integrator()(first, degree, farPart, 0, Meeting::Apart));
      TEST_COMPARE(difference(sum, one), <, 1e-22);
    }
}

TEUCHOS_UNIT_TEST(QuadMoments, orientationOfTouchingSegmentsOnlyChangesSigns) {
  const QuadCurve a = fromVertex(0, 1);
  const QuadCurve b = fromVertex(50, 0.4);
  const QuadCurve c = part(a, 1, 0);
  const QuadCurve d = part(b, 1, 0);
  PairMoments turned = integrator()(c, 3, d, 4, Meeting::ToTo);
  for (int f = 0; f < fields; ++f)
    for (int i = 0; i <= 3; ++i)
      for (int j = 0; j <= 4; ++j)
        if (((i + j) % 2 == 1) != (static_cast<Field>(f) >= Field::Direct))
          turned(static_cast<Field>(f), i, j) *= -1;
  TEST_COMPARE(difference(turned, integrator()(a, 3, b, 4, Meeting::FromFrom)), <, 1e-28);
}

// Couples all pairs of a polygon, self and touching and separated, with the mass matrix.
TEUCHOS_UNIT_TEST(QuadOperators, annihilateRigidMotionsTo20Digits) {
  for (const Sample& sample : quickSamples()) {
    const bem::Space space(sample.mesh);
    const QuadOperators exact = quadOperators(space, bem::Lame({1, 0.3, false}));
    for (const std::vector<Quad>& r : quadRigidMotions(space)) {
      for (const Quad& value : exact.doubleLayer* r)
        TEST_COMPARE(static_cast<double>(abs(value)), <, 1e-20);
      for (const Quad& value : exact.hypersingular* r)
        TEST_COMPARE(static_cast<double>(abs(value)), <, 1e-20);
    }
  }
}

}  // namespace

}  // namespace epafi::reference
