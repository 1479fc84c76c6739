#pragma once

#include "bem/compressed/CompressedFactor.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/body/ElasticBody.hpp"

namespace epafi::contact {

/// Multipliers up to which a stage may ask for D's entries.
constexpr Index mostCompressedColumns = 6000;

/// The sparse rows Ĉ = [B₀, -Nᵀ] by which the multiplier acts on displacements and densities,
/// of its own body and of those that it meets, and -M: what a compressed system has of it.
struct CompressedCoupling {
  std::vector<Coupling::Entry> entries;  ///< unknowns x multiplier
  std::vector<Coupling::Entry> mass;     ///< M
  /// What Ĉ does on a body with arcs to the exact rotation less the interpolated one.
  struct Rest {
    std::shared_ptr<const bem::Rotation> rotation;
    std::size_t body;
    Index first;    ///< displacement of it
    Vector values;  ///< by multipliers
  };
  std::vector<Rest> rests;
  Index first = 0;  ///< number of the first multiplier's unknown
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
  /// One of the operators' bodies.  All outlive it.
  CompressedHolding(const bem::CompressedOperators& operators, std::size_t body,
                    const Holding& holding);

  /// The held unknowns and springs of the body, all multipliers and all others held.
  const bem::Restriction& restriction() const { return restriction_; }
  const bem::CompressedOperators& operators() const { return operators_; }

  /// R and c, rigid motions that clamps do not hold and their functionals, by all unknowns.
  Index motions() const { return holding_.rigid.allowed.columns(); }
  Vector motion(Index k) const { return placed(holding_.rigid.allowed, k); }
  Vector functional(Index k) const { return placed(holding_.rigid.functionals, k); }

  /// Of M, the body with its springs.
  const bem::CompressedFactor& factor() const { return *factor_; }

  /// A⁺: displacements and densities under forces on both (columns), without the motions
  /// that clamps do not hold; zero on all else.
  Matrix displaced(Matrix forces) const;

 private:
  void addSprings();
  Vector placed(const Matrix& columns, Index k) const;

  const bem::CompressedOperators& operators_;
  const Holding& holding_;
  const bem::CompressedOperators::Range& range_;
  bem::Restriction restriction_;
  std::unique_ptr<const bem::CompressedFactor> factor_;
};

/// D = Ĉ A⁺ Ĉᵀ + M by solutions in the tree, A of all bodies.
std::shared_ptr<const Flexibility::Operator> compressedFlexibility(
    CompressedCoupling coupling,
    std::vector<std::shared_ptr<const CompressedHolding>> bodies);

}  // namespace epafi::contact
