#pragma once

#include "bem/compressed/CompressedFactor.hpp"
#include "contact/problem/Coupling.hpp"
#include "contact/problem/ElasticBody.hpp"

namespace epafi::contact {

/// Multipliers up to which a stage may ask for D's entries.
constexpr Index mostCompressedColumns = 6000;

/// The sparse rows Ĉ = [B₀, -Nᵀ] by which the multiplier acts on displacements and
/// densities, and -M: what a compressed system has of it.
struct CompressedCoupling {
  std::vector<Coupling::Entry> entries;  ///< unknowns x multiplier
  std::vector<Coupling::Entry> mass;     ///< M
  Index first = 0;                       ///< number of the first multiplier's unknown
  Index multipliers = 0;
  Index normals = 0;  ///< those of them that come first

  /// x += s Ĉᵀ λ on displacements and densities.
  void push(double s, const double* multiplier, double* x) const;
  /// Ĉ x
  Vector pull(const double* x) const;
};

/// A held body whose stiffness is compressed.  Where rigid motions are free or fixed, springs
/// make the system regular; what they change is taken back, see displaced().
class CompressedHolding {
 public:
  /// All outlive it.
  CompressedHolding(const bem::CompressedOperators& operators,
                    const CompressedCoupling& coupling, const Holding& holding);

  /// The held unknowns and springs of the body, every multiplier held.
  const bem::Restriction& restriction() const { return restriction_; }
  const bem::CompressedOperators& operators() const { return operators_; }
  const CompressedCoupling& coupling() const { return coupling_; }
  const RigidConstraints& rigid() const { return holding_.rigid; }

  /// Of M, the body with its springs.
  const bem::CompressedFactor& factor() const { return *factor_; }

  /// A⁺: displacements and densities under forces on both (columns), without the motions
  /// that clamps do not hold.
  Matrix displaced(Matrix forces) const;

 private:
  void addSprings();

  const bem::CompressedOperators& operators_;
  const CompressedCoupling& coupling_;
  const Holding& holding_;
  bem::Restriction restriction_;
  std::unique_ptr<const bem::CompressedFactor> factor_;
};

/// D = Ĉ A⁺ Ĉᵀ + M by solutions in the tree.  \pre `held` outlives it.
std::shared_ptr<const Flexibility::Operator> compressedFlexibility(
    std::shared_ptr<const CompressedHolding> held);

}  // namespace epafi::contact
