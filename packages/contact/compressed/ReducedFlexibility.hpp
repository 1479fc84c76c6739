#pragma once

#include "bem/algebra/LowRank.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

/// Some of the multiplier's coefficients in the tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// \pre `whole` outlives it.  \throws bem::NumericalError, as solve() may.
  ReducedFlexibility(const CompressedFlexibility& whole, System system);

  /// Of motions by the Schur complement of what answers them.
  Matrix solve(Matrix b) const override;

 private:
  /// x of a right side, all motions of size zero.
  Vector coefficients(const double* b) const;
  Vector solveSprung(Vector b) const;
  void makeCorrection();
  void makeBorder();
  const CompressedFlexibility::Along& factor() const {
    return whole_.eliminated(number_, restriction_);
  }

  const CompressedFlexibility& whole_;
  System system_;
  int number_;
  bem::Restriction restriction_;
  bem::Woodbury correction_;  ///< from D_M⁻¹ to D⁻¹ in the rows
  Matrix answers_;            ///< x for b = Ĝ in the rows
  bem::LuFactor border_;      ///< of Ĝᵀ times these
};

}  // namespace epafi::contact
