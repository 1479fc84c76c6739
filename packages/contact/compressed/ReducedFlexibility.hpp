#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

/// Some of the multiplier's coefficients in the tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// \pre `whole` outlives it.  \throws bem::NumericalError, as solve() may.
  ReducedFlexibility(const CompressedFlexibility& whole, System system);

  Vector solve(const Vector& b, const Vector& known) const override;

 private:
  Vector withoutMotions(Vector b, const Vector& known) const;
  Vector solveSprung(const Vector& b, const Vector& known) const;
  void makeCorrection();
  const bem::CompressedFactor& factor() const {
    return whole_.eliminated(number_, restriction_);
  }

  const CompressedFlexibility& whole_;
  System system_;
  int number_;
  bem::Restriction restriction_;
  Matrix solved_;             ///< D_M⁻¹ U, all coefficients
  bem::LuFactor correction_;  ///< of S⁻¹ + Uᵀ D_M⁻¹ U
};

}  // namespace epafi::contact
