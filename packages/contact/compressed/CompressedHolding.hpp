#pragma once

#include "bem/compressed/CompressedFactor.hpp"
#include "contact/body/Holding.hpp"
#include "contact/body/StabilisedBody.hpp"

namespace epafi::contact {

/// Leaves with multipliers, the only unknowns that become held or free between steps.
std::vector<int> furtherLeaves(const bem::CompressedOperators& operators);

/// A body with compressed stiffness and its Dirichlet conditions.  Springs on free or fixed rigid
/// motions make the system regular; displaced() removes their effect.
class CompressedHolding final : public HeldStiffness {
 public:
  /// One of the operators' bodies.  All outlive it, and so does `densities`, those of the last
  /// solution.
  CompressedHolding(const bem::CompressedOperators& operators, std::size_t body,
                    const Holding& holding, Vector& densities);

  /// A⁺ f + R Rᵀ f
  Vector solve(const Vector& force) const override;
  bool isFormed() const override { return false; }

  /// The held unknowns and springs of the body, all multipliers and all others held.
  const bem::Restriction& restriction() const { return restriction_; }
  const bem::CompressedOperators& operators() const { return operators_; }

  /// R and c, rigid motions that clamps do not hold and their functionals, by all unknowns.
  Matrix motions() const { return placed(holding_.allowed); }
  Matrix functionals() const { return placed(holding_.functionals); }

  /// Factor of M, the matrix of the body with springs.
  const bem::CompressedFactor& factor() const { return *factor_; }

  /// A⁺: displacements and densities for right-hand sides of both (columns), without allowed
  /// rigid motions; zero for all other unknowns.
  Matrix displaced(Matrix forces) const;

 private:
  void addSprings();
  Matrix placed(const Matrix& columns) const;

  const bem::CompressedOperators& operators_;
  const Holding& holding_;
  const bem::CompressedOperators::Range& range_;
  bem::Restriction restriction_;
  std::unique_ptr<const bem::CompressedFactor> factor_;
  Vector& densities_;
};

}  // namespace epafi::contact
