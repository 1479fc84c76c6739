#pragma once

#include "contact/law/FrictionLaw.hpp"

#include <limits>

namespace epafi::contact {

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
