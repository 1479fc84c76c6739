#pragma once

#include "bem/base/LowerTriangle.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/SingleLayerSolver.hpp"

#include <memory>

namespace epafi::bem {

/// The discrete Steklov-Poincaré operator, which maps displacements to tractions:
///
///   S = W + (K + 1/2)ᵀ V⁻¹ (K + 1/2) = W + Yᵀ Y,   V = L Lᵀ,  Y = L⁻¹ (K + 1/2)   [P
///   sec. 3]
///
/// Dimensionless (lengths by the outline's diameter, stresses by Young's modulus).
class SteklovPoincare {
 public:
  /// CPU seconds are not this class's business: callers time assembleOperators and this.
  /// \throws NumericalError if V is not positive definite.
  SteklovPoincare(Operators operators, const DenseAlgebra& algebra);

  /// The same with Z = V⁻¹ (K + 1/2) column by column:  S = W + (K + 1/2)ᵀ Z.
  SteklovPoincare(Operators operators, const DenseAlgebra& algebra,
                  const SingleLayerSolver& solver);

  /// S, my rows.
  const LowerTriangle& stiffness() const { return stiffness_; }
  /// The elements for whose projected tractions the assembly was asked.
  const std::vector<int>& tractionElements() const;
  /// The projected tractions on them; made at the first call, which is collective.
  std::shared_ptr<const TractionRows> tractions() const;
  const DenseAlgebra& algebra() const { return *algebra_; }

  SteklovPoincare(SteklovPoincare&&) noexcept;
  ~SteklovPoincare();

  Vector apply(const Vector& u) const;

  /// ψ = V⁻¹ (K + 1/2) u: the traction that belongs to u, as a density.          [P (15)]
  Vector density(const Vector& u) const;

  /// C + (K + 1/2)ᵀ V⁻¹ B, my rows of the displacements; B by my rows of the densities.
  Matrix addAdjointDensity(Matrix c, Matrix b) const;

 private:
  struct Tractions;

  const DenseAlgebra* algebra_;
  Index densities_ = 0;
  std::unique_ptr<CholeskyFactor> factor_;  ///< null: with a solver
  Matrix half_;                             ///< Y, or Z; my rows of the densities
  LowerTriangle stiffness_;
  std::unique_ptr<Tractions> tractions_;
};

}  // namespace epafi::bem
