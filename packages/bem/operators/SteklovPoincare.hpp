#pragma once

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/base/LowerTriangle.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/SingleLayerSolver.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace epafi::bem {

/// A compliance G = diag(g) that is added to V for some densities: the Lagrangian contains
/// -1/2 Σ g_k ψ_k² (doc/theory/contact.md, "Stabilisation by the density").
struct LocalCompliance {
  std::vector<Index> densities;  ///< distinct
  Vector diagonal;               ///< g_k > 0, one for each density
  /// (k, g_k) of densities that are zero in the solution; not part of ComplianceResponse.
  std::vector<std::pair<Index, double>> pinned;
};

class CompressedOperators;

/// Response to the densities of a LocalCompliance; E: their unit vectors as columns.
struct ComplianceResponse {
  std::vector<Index> densities;
  Matrix displacements;  ///< (K + 1/2)ᵀ (V + G)⁻¹ E
  Matrix density;        ///< Eᵀ (V + G)⁻¹ E
};

/// The discrete Steklov-Poincaré operator, which maps displacements to tractions:
///
///   S = W + (K + 1/2)ᵀ V⁻¹ (K + 1/2) = W + Yᵀ Y,   V = L Lᵀ,  Y = L⁻¹ (K + 1/2)
///                                                                           [P sec. 3]
///
/// With a LocalCompliance G, V + G replaces V, here and below:
/// A = W + (K + 1/2)ᵀ (V + G)⁻¹ (K + 1/2) <= S.
///
/// Dimensionless: lengths over the scaling of the outline, stresses over the reference
/// stress of Lame; all bodies share both.
class SteklovPoincare {
 public:
  /// S by a Cholesky factorization of V.
  /// \throws NumericalError if V is not positive definite
  explicit SteklovPoincare(Operators operators, const LocalCompliance& compliance = {});

  /// S = W + (K + 1/2)ᵀ Z, where `solver` computes Z = V⁻¹ (K + 1/2) column by column.
  SteklovPoincare(Operators operators, const SingleLayerSolver& solver,
                  const LocalCompliance& compliance = {});

  /// S of a body, not formed: below, only compressed() and compressedBody() are valid.
  explicit SteklovPoincare(std::shared_ptr<const CompressedOperators> operators,
                           std::size_t body = 0)
      : compressed_(std::move(operators)), body_(body) {}
  /// Null if S is formed.
  std::shared_ptr<const CompressedOperators> compressed() const { return compressed_; }
  std::size_t compressedBody() const { return body_; }

  /// S
  const LowerTriangle& stiffness() const { return stiffness_; }
  /// Response to the densities of the LocalCompliance; null without any.
  std::shared_ptr<const ComplianceResponse> response() const { return response_; }

  Vector apply(const Vector& u) const;

  /// ψ = V⁻¹ (K + 1/2) u, the density that approximates the traction.            [P (15)]
  Vector density(const Vector& u) const;

  /// V⁻¹ ((K + 1/2) u - E b), E as in ComplianceResponse.
  Vector density(const Vector& u, const Vector& b) const;

  /// V⁻¹ b, b a vector of all densities.
  /// \throws InputError with a SingleLayerSolver, if b is not in the span of E
  Vector densityOf(const Vector& b) const;

  /// C + (K + 1/2)ᵀ V⁻¹ B; with Pᵀ C if the displacements represent rotations exactly.
  Matrix addAdjointDensity(Matrix c, Matrix b) const;

 private:
  /// Permutes a vector of densities into the order of the factor, and back.
  Vector ordered(const Vector& b) const;
  Vector unordered(const Vector& b) const;

  std::shared_ptr<const CompressedOperators> compressed_;
  std::size_t body_ = 0;
  std::shared_ptr<const Rotation> rotation_;
  /// Density of each row of the factor; empty: the identity.  Densities with a compliance come
  /// last, so that their response needs only the last rows of the factor.
  std::vector<Index> order_;
  std::optional<CholeskyFactor> factor_;  ///< empty with a SingleLayerSolver
  Matrix solvedDoubleLayer_;              ///< Y, or Z
  Matrix units_;                          ///< with a solver: V⁻¹ E
  LowerTriangle stiffness_;
  std::shared_ptr<const ComplianceResponse> response_;
};

}  // namespace epafi::bem
