// Every friction law of the table, and one that a program adds.
#include "contact/law/FrictionLaw.hpp"

#include "contact/law/FrictionLaws.hpp"
#include "contact/problem/Tangential.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace epafi {

namespace {

using bem::Kind;
using contact::FrictionLaw;
using contact::FrictionLawMember;
using contact::Vector;

/// A law with the defaults of its keys; nothing for "None".
std::shared_ptr<const FrictionLaw> made(const FrictionLawMember& member) {
  Teuchos::ParameterList list;
  for (const bem::SchemaRow& row : member.rows)
    if (row.kind == Kind::Real)
      list.set(row.name(), std::stod(row.defaultValue));
  return member.make ? member.make(list) : nullptr;
}

std::size_t fieldsOf(const FrictionLawMember& member) {
  return static_cast<std::size_t>(std::count_if(
      member.rows.begin(), member.rows.end(),
      [](const bem::SchemaRow& row) { return row.kind == Kind::Expression; }));
}

Vector draw(std::size_t count, std::mt19937& random) {
  Vector values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::uniform_real_distribution<double>(0.05, 2)(random));
  return values;
}

// All but bonded sides, which have no bound.
template <class Claim>
void forEveryLaw(const Claim& claim) {
  std::mt19937 random(51);
  for (const FrictionLawMember& member : contact::frictionLaws())
    if (const auto law = made(member); law && !law->ties())
      for (int k = 0; k < 200; ++k)
        claim(*law, draw(fieldsOf(member), random), draw(1, random).front());
}

TEUCHOS_UNIT_TEST(FrictionLaw, slopeIsTheDifferenceQuotient) {
  int sloping = 0;
  forEveryLaw([&](const FrictionLaw& law, const Vector& fields, double pressure) {
    const double h = 1e-6;
    const double before = law.slope(pressure - h, fields);
    const double after = law.slope(pressure + h, fields);
    if (std::abs(before - after) > 1e-3)
      return;  // a kink
    const double quotient =
        (law.bound(pressure + h, fields) - law.bound(pressure - h, fields)) / (2 * h);
    TEST_COMPARE(std::abs(quotient - law.slope(pressure, fields)), <, 1e-8);
    TEST_ASSERT(law.dependsOnPressure() || quotient == 0);
    sloping += quotient > 0.01 ? 1 : 0;
  });
  TEST_COMPARE(sloping, >, 200);
}

TEUCHOS_UNIT_TEST(FrictionLaw, boundIsNeverNegativeAndMonotoneInItsFields) {
  int grows = 0;
  forEveryLaw([&](const FrictionLaw& law, const Vector& fields, double pressure) {
    TEST_COMPARE(law.bound(0, fields), >=, 0);
    TEST_COMPARE(law.bound(pressure, fields), >=, 0);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      Vector values;
      Vector more = fields;
      for (int k = 0; k < 20; ++k) {
        more[f] = 0.1 * k;
        values.push_back(law.bound(pressure, more));
      }
      TEST_ASSERT(std::is_sorted(values.begin(), values.end()) ||
                  std::is_sorted(values.rbegin(), values.rend()));
      grows += values.front() < values.back() ? 1 : 0;
    }
  });
  TEST_COMPARE(grows, >, 200);
}

TEUCHOS_UNIT_TEST(FrictionLaw, aProgramAddsOneToTheTableAndTheKeys) {
  class Offset final : public FrictionLaw {
   public:
    explicit Offset(double offset) : offset_(offset) {}
    double bound(double pressure, const Vector& fields) const override {
      return offset_ + fields[0] * pressure;
    }
    double slope(double /*pressure*/, const Vector& fields) const override {
      return fields[0];
    }

   private:
    double offset_;
  };
  bem::Family<FrictionLawMember>& laws = contact::frictionLaws();
  const FrictionLawMember member = {
      "Offset Coulomb of a test",
      {bem::Row("Coefficient", Kind::Expression, "1", "mu").required(),
       bem::Row("Offset", Kind::Real, "stress", "shear without pressure")
           .defaultValue("0.5")},
      [](const Teuchos::ParameterList& list) {
        return std::make_shared<const Offset>(list.get<double>("Offset"));
      }};
  laws.add(member);
  TEST_THROW(laws.add(member), bem::InputError);

  Teuchos::ParameterList list;
  list.set<std::string>("Law", member.name).set("Offset", 2.0);
  const contact::Friction friction =
      contact::parseFriction(list, [](const std::string& key) -> bem::Function {
        return key == "Coefficient" ? [](bem::Vec2 x) { return x.x; } : bem::Function();
      });
  TEST_EQUALITY(friction.at({0.25, 0}, 1).bound(8), 4);
  // the same in units in which a stress is 1000 times as large
  TEST_FLOATING_EQUALITY(friction.at({0.25, 0}, 1e3).bound(8), 2.002, 1e-14);

  int found = 0;
  for (const bem::SchemaRow& row : contact::frictionRows())
    if (std::count(row.only.begin(), row.only.end(), member.name) > 0)
      ++found;
  TEST_EQUALITY(found, 3);  // with Compliance, which all laws have
}

TEUCHOS_UNIT_TEST(FrictionLaw, aCoefficientMayDependOnPlaceAndPressure) {
  const contact::Friction friction = contact::makePressureFriction(
      [](const bem::SurfacePoint& x, double p) { return (0.3 + x.x) / (1 + p / 100); });
  for (const double stress : {1.0, 1e3}) {
    const contact::PointLaw law = friction.at({0.1, 7}, stress);
    for (const double p : {1e-12, 1.0, 50.0, 1e4, 1e9}) {
      const double share = 1 + p / 100;
      TEST_FLOATING_EQUALITY(law.bound(p / stress), 0.4 * p / share / stress, 1e-13);
      TEST_COMPARE(std::abs(law.slope(p / stress) - 0.4 / (share * share)), <, 1e-10);
    }
    TEST_EQUALITY(law.bound(-1), 0);
  }
  const contact::Friction falling = contact::makePressureFriction(
      [](const bem::SurfacePoint& /*x*/, double p) { return std::exp(-p); });
  TEST_NOTHROW(falling.at({}, 1).slope(0.99));
  TEST_THROW(falling.at({}, 1).slope(1.01), bem::InputError);
}

TEUCHOS_UNIT_TEST(FrictionLaw, keysThatDifferCannotShareAName) {
  const bem::SchemaRows one = {bem::Row("Key", Kind::Real, "a").only("A")};
  const bem::SchemaRows other = {bem::Row("Key", Kind::Whole, "b").only("B")};
  bem::SchemaRows table = one;
  TEST_THROW(append(table, other), bem::InputError);
  append(table, {bem::Row("Key", Kind::Real, "a").only("B")});
  TEST_EQUALITY(table.size(), 1u);
  TEST_EQUALITY(table.front().only.size(), 2u);
}

/// A law on an element; Coulomb's has no use for the cap.
std::vector<contact::Tangential> onElement(std::shared_ptr<const FrictionLaw> law,
                                           const contact::MultiplierBasis& basis,
                                           int degree, const bem::Function& coefficient,
                                           const bem::Function& cap) {
  std::vector<bem::Index> normals(degree + 1);
  std::iota(normals.begin(), normals.end(), 0);
  return contact::elementTangentials(
      basis, normals, std::move(law),
      [=](double t) {
        return Vector{coefficient({t, 0}), cap({t, 0})};
      },
      1);
}

// Of pressures of which some are negative.
TEUCHOS_UNIT_TEST(Tangential, slopesAreTheDerivativeAlsoAcrossTheCapAndBoundsScale) {
  std::mt19937 random(52);
  const double h = 1e-7;
  int sloping = 0;
  const std::shared_ptr<const FrictionLaw> laws[] = {
      std::make_shared<const contact::CoulombLaw>(),
      std::make_shared<const contact::CappedCoulombLaw>()};
  for (int k = 0; k < 300; ++k) {
    const double wave = draw(1, random).front();
    const auto bounds = onElement(
        laws[k % 2], contact::multiplierBasis("Bernstein"), 4,
        [wave](bem::Vec2 x) { return 0.5 + 0.2 * std::sin(wave * x.x); },
        [wave](bem::Vec2 x) { return 0.4 + 0.1 * std::cos(wave * x.x); });
    Vector pressures = draw(bounds.size(), random);
    const Vector direction = draw(bounds.size(), random);
    Vector more;
    Vector less;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      pressures[i] -= 0.3;
      more.push_back(pressures[i] + h * direction[i]);
      less.push_back(pressures[i] - h * direction[i]);
    }
    for (const contact::Tangential& bound : bounds) {
      const double slope = bound.slope(pressures);
      const double quotient = (bound.bound(more) - bound.bound(less)) / (2 * h);
      TEST_COMPARE(std::abs(quotient - slope * direction[bound.normal()]), <, 1e-6);
      TEST_COMPARE(slope, <=, bound.steepest());
      sloping += slope != 0 ? 1 : 0;
      const double one = bound.bound(pressures);
      TEST_COMPARE(std::abs(bound.scaled(3).bound(pressures) - 3 * one), <, 1e-14);
      TEST_EQUALITY(bound.scaled(0).bound(pressures), 0.0);
    }
  }
  TEST_COMPARE(sloping, >, 100);
}

}  // namespace

}  // namespace epafi
