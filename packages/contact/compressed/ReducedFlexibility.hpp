#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

/// Some of the multiplier's coefficients in the tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// Brings the factor up to date; both outlive it.
  /// \throws bem::NumericalError, and the factor is of no use any more.
  ReducedFlexibility(const CompressedFlexibility& whole, bem::CompressedFactor& factor,
                     System system);

  Vector solve(const Vector& b, const Vector& known) const override;

 private:
  Vector withoutMotions(Vector b, const Vector& known) const;
  Vector solveSprung(const Vector& b, const Vector& known) const;
  void makeCorrection();

  const CompressedFlexibility& whole_;
  bem::CompressedFactor& factor_;
  System system_;
  Matrix solved_;             ///< D_M⁻¹ U, all coefficients
  bem::LuFactor correction_;  ///< of S⁻¹ + Uᵀ D_M⁻¹ U
};

}  // namespace epafi::contact
