#pragma once

#include "contact/law/FrictionLaw.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace epafi::contact {

/// s = F, a threshold, whatever the pressure; also where the contact is open.     [P (2)]
class TrescaLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    return {bem::Row("Threshold", bem::Kind::Expression, "stress",
                     "largest shear stress, independent of the pressure")
                .required()};
  }

  double bound(double /*pressure*/, const Vector& fields) const override {
    return fields[0];
  }
  double slope(double /*pressure*/, const Vector& /*fields*/) const override { return 0; }
  bool dependsOnPressure() const override { return false; }
};

/// s = F λₙ, F the coefficient.                                                   [P (2)]
class CoulombLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    return {
        bem::Row("Coefficient", bem::Kind::Expression, "1",
                 "friction coefficient: shear up to coefficient times pressure; under "
                 "Coulomb it may use `pressure`")
            .required()};
  }

  double bound(double pressure, const Vector& fields) const override {
    return fields[0] * pressure;
  }
  double slope(double /*pressure*/, const Vector& fields) const override {
    return fields[0];
  }
};

/// s = F(x, λₙ) λₙ, increasing in λₙ.
class PressureCoulombLaw final : public FrictionLaw {
 public:
  explicit PressureCoulombLaw(PressureCoefficient coefficient)
      : coefficient_(std::move(coefficient)) {}
  static std::vector<bem::Function> fields();

  double bound(double pressure, const Vector& fields) const override;
  /// By central differences, to 1e-11 where F is smooth.
  /// \throws bem::InputError where s decreases
  double slope(double pressure, const Vector& fields) const override;
  bool knowsPlace() const override { return true; }

 private:
  PressureCoefficient coefficient_;
};

/// s = min(F λₙ, C): Coulomb's law up to a cap, the shear at which the surface itself
/// yields.                                        doc/theory/friction.md, [Wriggers06, 5.2]
class CappedCoulombLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    bem::SchemaRows rows = CoulombLaw::rows();
    rows.push_back(bem::Row("Cap", bem::Kind::Expression, "stress",
                            "largest shear stress, at any pressure")
                       .required());
    return rows;
  }

  double bound(double pressure, const Vector& fields) const override {
    return std::min(fields[0] * pressure, fields[1]);
  }
  double slope(double pressure, const Vector& fields) const override {
    return fields[0] * pressure < fields[1] ? fields[0] : 0;
  }
};

/// Bonded sides: any shear, and any pressure or tension.       doc/theory/friction.md
class TiedLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() { return {}; }

  double bound(double /*pressure*/, const Vector& /*fields*/) const override {
    return std::numeric_limits<double>::infinity();
  }
  double slope(double /*pressure*/, const Vector& /*fields*/) const override { return 0; }
  bool dependsOnPressure() const override { return false; }
  bool ties() const override { return true; }
};

}  // namespace epafi::contact
