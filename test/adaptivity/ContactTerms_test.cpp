#include "adaptivity/estimate/ContactTerms.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

using adaptivity::ContactProfiles;
using adaptivity::Contributions;
using adaptivity::Polynomial;
using adaptivity::SlipTerm;
using adaptivity::Source;

namespace {

constexpr double half = 0.2;
constexpr int degree = 2;
constexpr double size = 2 * half / degree;  // h/p

ContactProfiles resting() {
  const Polynomial zero([](double) { return 0.0; }, degree);
  const auto nothing = [](double) { return 0.0; };
  return {zero, zero, zero, nothing, nothing, degree, half};
}

Polynomial polynomial(const bem::Profile& f) { return {f, degree}; }

double term(const ContactProfiles& profiles, Source source,
            SlipTerm slipTerm = SlipTerm::Printed) {
  Contributions terms = contactTerms(profiles, slipTerm);
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
    for (const auto slipTerm : {SlipTerm::Printed, SlipTerm::Admissible})
      for (const double square : contactTerms(profiles, slipTerm))
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
TEUCHOS_UNIT_TEST(ContactTerms, ofTheAdmissibleShearLeaveItsExcessToTheBound) {
  ContactProfiles profiles = resting();
  profiles.pressure = polynomial([](double t) { return t; });
  profiles.shear = polynomial([](double t) { return 0.3 * t; });
  profiles.bound = [](double t) { return 0.3 * std::max(t, 0.0); };
  profiles.tangential = polynomial([](double) { return 2.0; });
  TEST_FLOATING_EQUALITY(term(profiles, Source::Slip, SlipTerm::Printed),
                         half * 2 * 0.3 * 0.5 * 2.0, 1e-13);
  TEST_COMPARE(std::abs(term(profiles, Source::Slip, SlipTerm::Admissible)), <, 1e-15);
  for (const auto slipTerm : {SlipTerm::Printed, SlipTerm::Admissible})
    TEST_FLOATING_EQUALITY(term(profiles, Source::Bound, slipTerm),
                           half * size * 0.09 / 3, 1e-13);
  // within the bound they are the same
  profiles.shear = polynomial([](double t) { return 0.2 * t * t; });
  profiles.bound = [](double) { return 0.5; };
  TEST_FLOATING_EQUALITY(term(profiles, Source::Slip, SlipTerm::Admissible),
                         term(profiles, Source::Slip, SlipTerm::Printed), 1e-13);
}

TEUCHOS_UNIT_TEST(ContactTerms, areNeverNegative) {
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
    for (const double square : contactTerms(profiles, SlipTerm::Admissible))
      TEST_COMPARE(square, >=, 0);
  }
}

}  // namespace epafi
