#pragma once

#include "contact/law/FrictionLaw.hpp"

namespace epafi::contact {

/// s = F, a threshold, whatever the pressure; also where the contact is open.     [P (2)]
class TrescaLaw final : public FrictionLaw {
 public:
  static bem::SchemaRows rows() {
    return {bem::Row("Threshold", bem::Kind::Expression,
                     "largest shear stress, independent of the pressure")
                .unit("stress")
                .required()};
  }

  double bound(double /*pressure*/, const Vector& fields) const override {
    return fields[0];
  }
  double slope(double /*pressure*/, const Vector& /*fields*/) const override { return 0; }
  bool dependsOnPressure() const override { return false; }
};

}  // namespace epafi::contact
