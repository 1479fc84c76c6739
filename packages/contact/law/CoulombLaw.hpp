#pragma once

#include "contact/law/FrictionLaw.hpp"

namespace epafi::contact {

/// s = F λₙ, F the coefficient.                                                   [P (2)]
class CoulombLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    return {bem::Row("Coefficient", bem::Kind::Expression,
                     "friction coefficient: shear up to coefficient times pressure")
                .unit("1")
                .required()};
  }

  double bound(double pressure, const Vector& fields) const override {
    return fields[0] * pressure;
  }
  double slope(double /*pressure*/, const Vector& fields) const override {
    return fields[0];
  }
};

}  // namespace epafi::contact
