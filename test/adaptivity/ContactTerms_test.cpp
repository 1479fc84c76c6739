#include "adaptivity/estimate/ContactTerms.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

using adaptivity::ContactProfiles;
using adaptivity::Contributions;
using adaptivity::Polynomial;
using adaptivity::Source;

namespace {

constexpr double half = 0.2;
constexpr int degree = 2;
constexpr double size = 2 * half / degree;  // h/p

ContactProfiles resting() {
  const Polynomial zero([](double) { return 0.0; }, degree);
  const auto nothing = [](double) { return 0.0; };
  return {zero, zero, zero, nothing, nothing, degree, half, [](double) { return half; }};
}

Polynomial polynomial(const bem::Profile& f) { return {f, degree}; }

constexpr double shearModulus = 0.4;

double term(const ContactProfiles& profiles, Source source) {
  Contributions terms = contactTerms(profiles);
  return of(terms, source);
}

double sharpTerm(const ContactProfiles& profiles, Source source) {
  Contributions terms = sharpContactTerms(profiles, shearModulus);
  return of(terms, source);
}

}  // namespace

TEUCHOS_UNIT_TEST(ContactTerms, vanishWhereNothingIsViolated) {
  ContactProfiles open = resting();
  open.opening = [](double t) { return 2 + t; };
  ContactProfiles stuck = resting();
  stuck.pressure = polynomial([](double t) { return 1 + t * t; });
  stuck.shear = polynomial([](double t) { return 0.4 * t; });
  stuck.bound = [](double) { return 0.5; };
  ContactProfiles slipping = stuck;
  slipping.shear = polynomial([](double) { return -0.5; });
  slipping.tangential = polynomial([](double t) { return -2 + t; });
  for (const ContactProfiles& profiles : {open, stuck, slipping})
    for (const Contributions& squares :
         {contactTerms(profiles), sharpContactTerms(profiles, shearModulus)})
      for (const double square : squares)
        TEST_COMPARE(std::abs(square), <, 1e-30);
}

// The zero of the pressure lies inside: a rule across it would err by percents.
TEUCHOS_UNIT_TEST(ContactTerms, areExactAcrossSignChanges) {
  const double zero = 0.137;
  ContactProfiles profiles = resting();
  profiles.pressure = polynomial([=](double t) { return t - zero; });
  profiles.opening = [](double t) { return 3 * (t + 0.4); };
  const double right = 1 - zero;
  const double left = 1 + zero;
  TEST_FLOATING_EQUALITY(
      term(profiles, Source::Complementarity),
      half * 3 * (std::pow(right, 3) / 3 + (zero + 0.4) * right * right / 2), 1e-14);
  TEST_FLOATING_EQUALITY(term(profiles, Source::Tension),
                         half * size * std::pow(left, 3) / 3, 1e-14);
  TEST_FLOATING_EQUALITY(term(profiles, Source::Penetration),
                         half / size * 9 * std::pow(0.6, 3) / 3, 1e-14);
  TEST_EQUALITY(term(profiles, Source::Bound), 0);
  TEST_EQUALITY(term(profiles, Source::Slip), 0);
}

TEUCHOS_UNIT_TEST(ContactTerms, measureShearBeyondTheBoundAndSlipBelowIt) {
  ContactProfiles profiles = resting();
  profiles.shear = polynomial([](double t) { return t; });
  profiles.bound = [](double) { return 0.6; };
  profiles.tangential = polynomial([](double) { return 2.0; });
  TEST_FLOATING_EQUALITY(term(profiles, Source::Bound),
                         half * size * 2 * std::pow(0.4, 3) / 3, 1e-14);
  // (0.6 - |t|) * 2 over |t| < 0.6, and 2 |t| * 2 where shear and slip disagree, t < 0
  TEST_FLOATING_EQUALITY(term(profiles, Source::Slip), half * (2 * 0.36 + 2), 1e-14);
}

/// Where the pressure dips below zero, Coulomb's shear has the wrong sign.
TEUCHOS_UNIT_TEST(SharpContactTerms, leaveShearBeyondTheBoundToTheBound) {
  ContactProfiles profiles = resting();
  profiles.pressure = polynomial([](double t) { return t; });
  profiles.shear = polynomial([](double t) { return 0.3 * t; });
  profiles.bound = [](double t) { return 0.3 * std::max(t, 0.0); };
  profiles.tangential = polynomial([](double) { return 2.0; });
  TEST_FLOATING_EQUALITY(term(profiles, Source::Slip), half * 2 * 0.3 * 0.5 * 2.0, 1e-13);
  TEST_COMPARE(std::abs(sharpTerm(profiles, Source::Slip)), <, 1e-15);
  TEST_FLOATING_EQUALITY(term(profiles, Source::Bound), half * size * 0.09 / 3, 1e-13);
  TEST_FLOATING_EQUALITY(sharpTerm(profiles, Source::Bound), half * size * 0.09 / 3,
                         1e-13);
}

// A small gap under pressure and a small slip below the bound are errors of the
// displacement, a small pressure at a gap and a bound nearly reached are errors of the
// multiplier: all count squared.
TEUCHOS_UNIT_TEST(SharpContactTerms, areQuadraticInSmallViolations) {
  const double stiffness = shearModulus / size;
  ContactProfiles profiles = resting();
  const auto violate = [&](double force, double length) {
    profiles.pressure = polynomial([=](double t) { return force * (2 + t); });
    profiles.opening = [=](double t) { return length * (2 + t); };
    profiles.bound = [=](double) { return 0.5; };
    profiles.shear = polynomial([=](double t) { return force * (2 + t) - 0.5; });
    profiles.tangential = polynomial([=](double t) { return -length * (2 + t); });
  };
  const double integral = half * (8 + 2.0 / 3);
  violate(0.1, 1e-4);
  for (const Source source : {Source::Complementarity, Source::Slip})
    TEST_FLOATING_EQUALITY(sharpTerm(profiles, source), stiffness * 1e-8 * integral,
                           1e-12);
  violate(1e-4, 0.1);
  for (const Source source : {Source::Complementarity, Source::Slip})
    TEST_FLOATING_EQUALITY(sharpTerm(profiles, source), 1e-8 / stiffness * integral,
                           1e-12);
}

TEUCHOS_UNIT_TEST(LostWork, isTheLeastOverAllSplits) {
  constexpr double stiffness = 1.7;
  constexpr int steps = 400;
  for (const double force : {0.0, 0.3, 1.0, 4.0})
    for (const double length : {0.0, 0.1, 0.6, 2.0}) {
      double least = force * length;
      for (int i = 0; i <= steps; ++i)
        for (int k = 0; k <= steps; ++k) {
          const double f = force * i / steps;
          const double v = length * k / steps;
          least = std::min(least, f * v + (force - f) * (force - f) / stiffness +
                                      stiffness * (length - v) * (length - v));
        }
      const double work = adaptivity::lostWork(force, length, stiffness);
      TEST_COMPARE(work, <=, least + 1e-15);
      TEST_COMPARE(work, >=, least - 1e-4);
    }
}

/// A point that comes into an open element by a depth costs what it does in a small element.
TEUCHOS_UNIT_TEST(ContactTerms, narrowOverlapsCostTheSameInLongElements) {
  const double slope = 0.7;
  const double depth = 0.01;
  const double stored = depth * depth / 3;  // of the triangle, over its length
  for (const double length : {0.1, 10.0, 1000.0}) {
    ContactProfiles profiles = resting();
    profiles.half = length / 2;
    profiles.measure = [=](double) { return length / 2; };
    profiles.opening = [=](double t) { return slope * length * (1 + t) / 2 - depth; };
    narrow(profiles);
    TEST_FLOATING_EQUALITY(sharpTerm(profiles, Source::Penetration), stored, 1e-9);
  }
  ContactProfiles wide = resting();
  wide.opening = [](double) { return -0.1; };
  const double before = sharpTerm(wide, Source::Penetration);
  narrow(wide);
  TEST_EQUALITY(sharpTerm(wide, Source::Penetration), before);
}

TEUCHOS_UNIT_TEST(ContactTerms, areNeverNegativeAndTheSharpOnesNotLarger) {
  for (int trial = 0; trial < 40; ++trial) {
    ContactProfiles profiles = resting();
    const auto any = [trial](int k) {
      return [=](double t) { return std::sin(1.0 + trial + 2.3 * k + (1 + k) * t); };
    };
    profiles.pressure = polynomial(any(0));
    profiles.shear = polynomial(any(1));
    profiles.tangential = polynomial(any(2));
    profiles.opening = any(3);
    profiles.bound = [](double t) { return 0.3 + 0.2 * t; };
    const Contributions printed = contactTerms(profiles);
    const Contributions sharp = sharpContactTerms(profiles, shearModulus);
    for (std::size_t k = 0; k < printed.size(); ++k) {
      TEST_COMPARE(sharp[k], >=, 0);
      TEST_COMPARE(sharp[k], <=,
                   printed[k] * (1 + 1e-13));  // other rules, other rounding
    }
  }
}

}  // namespace epafi
