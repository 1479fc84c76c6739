#pragma once

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/base/LowerTriangle.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/SingleLayerSolver.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace epafi::bem {

/// A compliance G = diag(g) of some densities, in addition to V: 1/2 Σ g_k ψ_k² is taken
/// from the Lagrangian (doc/theory/contact.md, "Stabilisation by the density").
struct LocalCompliance {
  std::vector<Index> densities;  ///< each once
  Vector diagonal;               ///< one g_k > 0 each
  /// The same of densities that are zero in the solution: nothing asks for their response.
  std::vector<std::pair<Index, double>> pinned;
};

class CompressedOperators;

/// What the densities E of a LocalCompliance do by themselves.
struct DensityResponse {
  std::vector<Index> densities;
  Matrix displacements;  ///< (K + 1/2)ᵀ (V + G)⁻¹ E
  Matrix density;        ///< Eᵀ (V + G)⁻¹ E
};

/// The discrete Steklov-Poincaré operator, which maps displacements to tractions:
///
///   S = W + (K + 1/2)ᵀ V⁻¹ (K + 1/2) = W + Yᵀ Y,   V = L Lᵀ,  Y = L⁻¹ (K + 1/2)
///                                                                           [P sec. 3]
///
/// With a LocalCompliance G it is  A = W + (K + 1/2)ᵀ (V + G)⁻¹ (K + 1/2) <= S,  and V + G
/// stands wherever V stands below.
///
/// Dimensionless, by the outline's scaling and the reference stress of Lame, which several
/// bodies share.
class SteklovPoincare {
 public:
  /// CPU seconds are not this class's business: callers time assembleOperators and this.
  /// \throws NumericalError if V is not positive definite.
  explicit SteklovPoincare(Operators operators, const LocalCompliance& compliance = {});

  /// The same with Z = V⁻¹ (K + 1/2) column by column:  S = W + (K + 1/2)ᵀ Z.
  SteklovPoincare(Operators operators, const SingleLayerSolver& solver,
                  const LocalCompliance& compliance = {});

  /// S of one of the operators' bodies, never formed: nothing below but this is there.
  explicit SteklovPoincare(std::shared_ptr<const CompressedOperators> operators,
                           std::size_t body = 0)
      : compressed_(std::move(operators)), body_(body) {}
  /// Null where S is formed.
  std::shared_ptr<const CompressedOperators> compressed() const { return compressed_; }
  std::size_t compressedBody() const { return body_; }

  /// S
  const LowerTriangle& stiffness() const { return stiffness_; }
  /// The elements for whose projected tractions the assembly was asked.
  const std::vector<int>& tractionElements() const { return tractionElements_; }
  /// The projected tractions on them.
  std::shared_ptr<const TractionRows> tractions() const { return tractions_; }
  /// Of the densities with a compliance of their own; null without any.
  std::shared_ptr<const DensityResponse> response() const { return response_; }

  Vector apply(const Vector& u) const;

  /// ψ = V⁻¹ (K + 1/2) u: the traction that belongs to u, as a density.          [P (15)]
  Vector density(const Vector& u) const;

  /// V⁻¹ ((K + 1/2) u - E b), E the unit vectors of response().
  Vector density(const Vector& u, const Vector& b) const;

  /// V⁻¹ b, b by all densities.
  /// \throws InputError where solved for column by column, but for those of response().
  Vector densityOf(const Vector& b) const;

  /// C + (K + 1/2)ᵀ V⁻¹ B, with Pᵀ C where displacements hold a rotation beside polynomials.
  Matrix addAdjointDensity(Matrix c, Matrix b) const;

 private:
  void makeTractions(TractionKernels kernels);
  void addRaised(const std::vector<TractionKernels::Raised>& raised, const Matrix& lowest,
                 Matrix& rows) const;

  /// A vector of the densities in the order of the factor, and back.
  Vector ordered(const Vector& b) const;
  Vector unordered(const Vector& b) const;

  std::shared_ptr<const CompressedOperators> compressed_;
  std::size_t body_ = 0;
  std::shared_ptr<const Rotation> rotation_;
  /// Density of each row of the factor; empty: as numbered.  Those with a compliance come
  /// last, so that what they do needs but the end of the factor.
  std::vector<Index> order_;
  std::optional<CholeskyFactor> factor_;  ///< none: with a solver
  Matrix half_;                           ///< Y, or Z
  Matrix units_;                          ///< with a solver: V⁻¹ E
  LowerTriangle stiffness_;
  std::shared_ptr<const DensityResponse> response_;
  std::vector<int> tractionElements_;
  std::shared_ptr<const TractionRows> tractions_;
};

}  // namespace epafi::bem
