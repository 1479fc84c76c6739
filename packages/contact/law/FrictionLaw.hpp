#pragma once

#include "contact/law/Law.hpp"

namespace epafi::contact {

/// Friction law |λₜ| ≤ s(λₙ) with slip bound s.                [P (2)], doc/theory/friction.md
///
/// In the user's units.  Parameters that depend on the place (coefficient, threshold) are
/// fields: `fields` contains their values at the point, each >= 0, in the order of the
/// rows. Constant parameters are members of the class.  s is monotone in each field.
class FrictionLaw {
 public:
  virtual ~FrictionLaw() = default;

  /// s >= 0 at a pressure >= 0.  The estimate asks several threads at a time.
  virtual double bound(double pressure, const Vector& fields) const = 0;

  /// ds/dpressure at a pressure >= 0; at a kink one of the one-sided derivatives, at zero
  /// the right one.
  virtual double slope(double pressure, const Vector& fields) const = 0;

  virtual bool dependsOnPressure() const { return true; }

  /// Are the fields the place, x, y and the normal's components, of any sign?
  virtual bool knowsPlace() const { return false; }

  /// Are the sides bonded?  Then the bound is infinite, the normal stress has any sign,
  /// and the gap of the condition is a given jump of the displacement.
  virtual bool ties() const { return false; }
};

using FrictionLawMember = LawMember<FrictionLaw>;

/// All laws, built-in ones and those added by a program.
bem::Family<FrictionLawMember>& frictionLaws();

/// Rows: Law, the keys of each law, and Compliance for all but the first law.
bem::SchemaRows frictionRows();

/// A law at one point, dimensionless: numbers only.
///
///   s(p) = m law(stress p, fields) / stress
class PointLaw {
 public:
  PointLaw() = default;  ///< no friction: s = 0
  /// s = bound >= 0 at any pressure.
  explicit PointLaw(double bound) : bound_(bound) {}
  /// `stress`: the unit of dimensionless stresses.
  PointLaw(std::shared_ptr<const FrictionLaw> law, Vector fields, double stress)
      : law_(std::move(law)), fields_(std::move(fields)), stress_(stress) {}

  /// With m multiplied by a factor >= 0.
  void scale(double factor) { factor_ *= factor; }

  /// s(p⁺) >= 0.
  double bound(double pressure) const;
  /// ds/dp for p > 0, else zero.
  double slope(double pressure) const;
  /// The largest s'(p) and (s(p) - s(0))/p, sampled at p = 1e-18, 1e-17, ..., 1.
  double steepest() const;
  bool followsPressure() const { return law_ != nullptr && law_->dependsOnPressure(); }

 private:
  std::shared_ptr<const FrictionLaw> law_;
  Vector fields_;
  double stress_ = 1;
  double bound_ = 0;
  double factor_ = 1;  ///< m
};

/// Friction law of a boundary and shear compliance of its surfaces [length/stress]; their
/// elastic shear does not count as slip.
struct Friction : LawOnBoundary<FrictionLaw> {
  bem::Function compliance{};  ///< empty: zero

  bool ties() const { return law != nullptr && law->ties(); }
  PointLaw at(const bem::SurfacePoint& place, double stress) const {
    return law == nullptr ? PointLaw() : PointLaw(law, fieldsAt(place), stress);
  }
};

/// A law whose keys are all fields.
/// \throws bem::InputError for an unknown name, or another number of fields.
Friction makeFriction(const std::string& law, std::vector<bem::Function> fields);

/// A friction coefficient F(x, λₙ) >= 0 at a pressure >= 0, in the user's units; thread-safe.
using PressureCoefficient =
    std::function<double(const bem::SurfacePoint&, double pressure)>;

/// Coulomb's law with this coefficient.
Friction makePressureFriction(PressureCoefficient coefficient);

/// From a list that frictionRows() has checked; `field` makes the function of a key.
Friction parseFriction(const Teuchos::ParameterList& list, const FieldOf& field);

}  // namespace epafi::contact
