#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

/// Some of the multiplier's coefficients in the tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// Eliminates anew where the system differs from that of `earlier`, which stays as it is.
  /// \pre `whole` outlives it.  \throws bem::NumericalError
  ReducedFlexibility(const CompressedFlexibility& whole,
                     const bem::CompressedFactor& earlier, System system);

  std::shared_ptr<const bem::CompressedFactor> factor() const { return factor_; }
  Vector solve(const Vector& b, const Vector& known) const override;

 private:
  Vector withoutMotions(Vector b, const Vector& known) const;
  Vector solveSprung(const Vector& b, const Vector& known) const;
  void makeCorrection();

  const CompressedFlexibility& whole_;
  System system_;
  std::shared_ptr<const bem::CompressedFactor> factor_;
  Matrix solved_;             ///< D_M⁻¹ U, all coefficients
  bem::LuFactor correction_;  ///< of S⁻¹ + Uᵀ D_M⁻¹ U
};

}  // namespace epafi::contact
