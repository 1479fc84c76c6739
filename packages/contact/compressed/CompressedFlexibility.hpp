#pragma once

#include "contact/compressed/CompressedCoupling.hpp"
#include "contact/compressed/CompressedHolding.hpp"
#include "contact/problem/Flexibility.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// D = Ĉ A⁺ Ĉᵀ + M by solutions in the tree, A of all bodies.
class CompressedFlexibility final : public Flexibility::Operator {
 public:
  CompressedFlexibility(CompressedCoupling coupling,
                        std::vector<std::shared_ptr<const CompressedHolding>> bodies);

  Index size() const override { return coupling_.multipliers; }
  Vector times(const Vector& x) const override;
  /// |D| |x| from the rows' sums over each kind and its largest coefficient.
  Product product(const Vector& x) const override;
  std::unique_ptr<Factor> factor(System system) const override;
  Matrix formed() const override;
  void release() const override;

  const CompressedCoupling& coupling() const { return coupling_; }
  const bem::CompressedOperators& operators() const {
    return bodies_.front()->operators();
  }
  /// Of all bodies, every multiplier held.
  const bem::Restriction& restriction() const { return factor_->restriction(); }
  /// What D has beyond D_M, that of springs in place of A⁺: each motion R of a body goes through its
  /// functional c,  D = D_M - G wᵀ - w Gᵀ + G κ Gᵀ,  w = Ĉ M⁻¹ c,  κ = cᵀ M⁻¹ c,  G = Ĉ R.
  const bem::LowRank& motions() const { return motions_; }
  /// Of the leaves that the multiplier acts on.
  const std::vector<char>& paths() const { return paths_; }

  /// Of systems in some of the coefficients one is eliminated, the last that was asked for: one for
  /// each would keep twice the memory.  Another one's turn brings it back.
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
  mutable Matrix rowSums_;  ///< over each kind, once asked for
  // Kept from step to step, so that only what changes is eliminated anew.
  mutable std::unique_ptr<bem::CompressedFactor> reduced_;
  mutable int eliminated_ = 0;  ///< the number of its system; 0: of none
  mutable int numbers_ = 0;     ///< given to systems
};

}  // namespace epafi::contact
