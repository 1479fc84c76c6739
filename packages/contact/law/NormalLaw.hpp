#pragma once

#include "bem/base/Material.hpp"
#include "contact/law/Law.hpp"

#include <cassert>

namespace epafi::contact {

/// Normal compliance φ of contact surfaces (roughness, coating, gasket):
///
///   uₙ <= g + φ(λₙ),   φ(0) = 0, increasing.                    doc/theory/surfaces.md
///
/// In the user's units; fields as in FrictionLaw, each > 0 unless the law is linear.
class NormalLaw {
 public:
  virtual ~NormalLaw() = default;

  /// φ >= 0 at a pressure >= 0 [length].
  virtual double closing(double pressure, const Vector& fields) const = 0;
  /// dφ/dp > 0 at a pressure > 0; at zero it may be zero or infinite.
  virtual double slope(double pressure, const Vector& fields) const = 0;
  /// Stored energy ∫ s φ'(s) ds, 0 ... p, per length [stress length].
  virtual double energy(double pressure, const Vector& fields) const = 0;

  /// Is φ linear in p?  Linear laws are allowed with any basis and on bonded sides.
  virtual bool isLinear() const { return false; }
};

using NormalLawMember = LawMember<NormalLaw>;

/// All laws, built-in ones and those added by a program.
bem::Family<NormalLawMember>& normalLaws();

/// Rows: Law, and the keys of each law.
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

/// Normal law of a boundary; null: rigid surfaces, φ = 0.
struct Normal : LawOnBoundary<NormalLaw> {
  /// \pre there is a law
  PointClosing at(const bem::SurfacePoint& place, bem::Units units) const {
    assert(law != nullptr);
    return {law, fieldsAt(place), units};
  }
};

/// A law of the table that has no keys but fields.
/// \throws bem::InputError for an unknown name, or another number of fields.
Normal makeNormal(const std::string& law, std::vector<bem::Function> fields);

/// From a list that normalRows() has checked; `field` makes the function of a key.
Normal parseNormal(const Teuchos::ParameterList& list, const FieldOf& field);

}  // namespace epafi::contact
