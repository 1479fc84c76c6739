#pragma once

#include "contact/compressed/CompressedCoupling.hpp"
#include "contact/compressed/CompressedHolding.hpp"
#include "contact/problem/Flexibility.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// Compliance matrix D = Ĉ A⁺ Ĉᵀ + M by solutions in the cluster tree, A of all bodies.
class CompressedFlexibility final : public Flexibility::Operator {
 public:
  CompressedFlexibility(CompressedCoupling coupling,
                        std::vector<std::shared_ptr<const CompressedHolding>> bodies);

  Index size() const override { return coupling_.multipliers; }
  Vector times(const Vector& x) const override;
  /// Estimates |D| |x| by row sums times the largest |x_j|, for each kind of coefficient.
  Product product(const Vector& x) const override;
  std::unique_ptr<Factor> factor(System system) const override;
  Matrix formed() const override;
  void release() const override;

  const CompressedCoupling& coupling() const { return coupling_; }
  const bem::CompressedOperators& operators() const {
    return bodies_.front()->operators();
  }
  /// Restriction of all bodies with all multipliers held.
  const bem::Restriction& restriction() const { return factor_->restriction(); }
  /// Low-rank difference of D and D_M, which has springs on rigid motions R with
  /// functionals c: D = D_M - G wᵀ - w Gᵀ + G κ Gᵀ,  w = Ĉ M⁻¹ c,  κ = cᵀ M⁻¹ c,  G = Ĉ
  /// R.
  const bem::LowRank& motions() const { return motions_; }
  /// CompressedFactor::paths of the leaves coupled to the multiplier.
  const std::vector<char>& paths() const { return paths_; }

  /// Factor of a system in some of the coefficients.  Only the last requested system is
  /// stored; a request for another one eliminates it again.
  /// \throws bem::NumericalError
  const bem::CompressedFactor& eliminated(int number,
                                          const bem::Restriction& restriction) const;
  int nextNumber() const { return ++numbers_; }

 private:
  int kindOf(Index i) const { return i < coupling_.normals ? 0 : 1; }
  void factorAll();
  void findPaths();
  void addMotions();
  void measureRows() const;
  Matrix timesColumns(const Matrix& x) const;

  CompressedCoupling coupling_;
  std::vector<std::shared_ptr<const CompressedHolding>> bodies_;
  std::unique_ptr<bem::CompressedFactor> factor_;
  std::vector<char> paths_;
  bem::LowRank motions_;
  mutable Matrix rowSums_;  ///< over each kind, computed on first use
  // Kept between steps, so that only changed leaves and their ancestors are eliminated
  // again.
  mutable std::unique_ptr<bem::CompressedFactor> reduced_;
  mutable int eliminated_ = 0;  ///< the number of its system; 0: of none
  mutable int numbers_ = 0;     ///< given to systems
};

}  // namespace epafi::contact
