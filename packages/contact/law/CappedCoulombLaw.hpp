#pragma once

#include "contact/law/CoulombLaw.hpp"

#include <algorithm>

namespace epafi::contact {

/// s = min(F λₙ, C): Coulomb's law up to a cap, the shear at which the surface itself
/// yields.                                        doc/theory/friction.md, [Wriggers06, 5.2]
class CappedCoulombLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    bem::SchemaRows rows = CoulombLaw::rows();
    rows.push_back(
        bem::Row("Cap", bem::Kind::Expression, "largest shear stress, at any pressure")
            .unit("stress")
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

}  // namespace epafi::contact
