#pragma once

#include "bem/base/Material.hpp"
#include "contact/law/Law.hpp"

namespace epafi::contact {

/// How far the surfaces of a contact yield to its pressure: roughness, a coating, a gasket,
///
///   uₙ <= g + φ(λₙ),   φ(0) = 0, increasing.                    doc/theory/surfaces.md
///
/// In the user's units, with fields as a FrictionLaw has them, each > 0 unless the law is linear.
class NormalLaw {
 public:
  virtual ~NormalLaw() = default;

  /// φ >= 0 at a pressure >= 0 [length].
  virtual double closing(double pressure, const Vector& fields) const = 0;
  /// dφ/dp > 0 at a pressure > 0; at zero it may be zero or infinite.
  virtual double slope(double pressure, const Vector& fields) const = 0;
  /// ∫ s φ'(s) ds from 0 to p: what is stored per length [stress length].
  virtual double energy(double pressure, const Vector& fields) const = 0;

  /// φ = slope p?  Such a law goes with any basis, and with bonds.
  virtual bool isLinear() const { return false; }
};

using NormalLawMember = LawMember<NormalLaw>;

/// All laws: Epafi's own, and what a program adds.
bem::Family<NormalLawMember>& normalLaws();

/// Law, and under each law its own keys.
bem::SchemaRows normalRows();

/// A law at one point, dimensionless: numbers only.
///
///   φ(p) = law(stress p, fields) / length,   p < 0: zero, of a linear law φ'(0) p
class PointClosing {
 public:
  PointClosing(std::shared_ptr<const NormalLaw> law, Vector fields, bem::Units units)
      : law_(std::move(law)), fields_(std::move(fields)), units_(units) {}

  double closing(double pressure) const;
  /// At a pressure's positive part.
  double slope(double pressure) const;
  double energy(double pressure) const;
  /// The pressure p >= 0 with p + c φ(p) = z, c >= 0; zero where z <= 0.
  double resolvent(double c, double z) const;

 private:
  std::shared_ptr<const NormalLaw> law_;
  Vector fields_;
  bem::Units units_;
};

/// The normal law of a boundary; none: the surfaces do not yield.
struct Normal : LawOnBoundary<NormalLaw> {
  /// \pre there is a law
  PointClosing at(bem::Vec2 place, bem::Units units) const {
    return {law, fieldsAt(place), units};
  }
};

/// A law of the table that has no keys but fields.
/// \throws bem::InputError for an unknown name, or another number of fields.
Normal makeNormal(const std::string& law, std::vector<bem::Function> fields);

/// From a list that normalRows() has checked; `field` makes the function of a key.
Normal parseNormal(const Teuchos::ParameterList& list, const FieldOf& field);

}  // namespace epafi::contact
