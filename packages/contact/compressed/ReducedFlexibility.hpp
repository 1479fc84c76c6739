#pragma once

#include "bem/algebra/LowRank.hpp"
#include "contact/compressed/CompressedFlexibility.hpp"

namespace epafi::contact {

/// Factor of a linear system in some coefficients of D, by the cluster tree.
class ReducedFlexibility final : public Flexibility::Operator::Factor {
 public:
  using System = Flexibility::Operator::System;

  /// Refers to `whole`.  \throws bem::NumericalError if singular, as solve() does
  ReducedFlexibility(const CompressedFlexibility& whole, System system);

  /// Rigid motions by their Schur complement Ĝᵀ D⁻¹ Ĝ + K̂.
  Matrix solve(Matrix b) const override;

 private:
  /// x for right-hand sides b (columns), with β = 0.
  Matrix coefficients(Matrix b) const;
  /// The same with D_M, see CompressedFlexibility::motions.
  Matrix solveSprung(Matrix b) const;
  /// From D_M⁻¹ U in the rows.
  void makeCorrection(Matrix answers);
  void makeBorder();
  const CompressedFlexibility::Along& factor() const {
    return whole_.eliminated(number_, restriction_);
  }

  const CompressedFlexibility& whole_;
  System system_;
  int number_;
  bem::Restriction restriction_;
  bem::Woodbury correction_;  ///< from D_M⁻¹ to D⁻¹ in the rows
  Matrix answers_;            ///< x for b = Ĝ: D⁻¹ Ĝ
  bem::LuFactor border_;      ///< of the Schur complement
};

}  // namespace epafi::contact
