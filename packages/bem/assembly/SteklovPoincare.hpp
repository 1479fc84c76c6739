#pragma once

#include "bem/assembly/Assembly.hpp"

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

  /// S, the lower triangle, my rows.
  const Matrix& stiffness() const { return stiffness_; }
  /// Y, my rows of the densities.
  const Matrix& half() const { return half_; }
  /// The kernels of the projected tractions that the assembly was asked for.
  const TractionKernels& tractions() const { return tractions_; }
  const CholeskyFactor& singleLayer() const { return *factor_; }
  const DenseAlgebra& algebra() const { return *algebra_; }

  Vector apply(const Vector& u) const;

  /// ψ = V⁻¹ (K + 1/2) u: the traction that belongs to u, as a density.          [P (15)]
  Vector density(const Vector& u) const;

 private:
  const DenseAlgebra* algebra_;
  std::unique_ptr<CholeskyFactor> factor_;
  Matrix half_;
  Matrix stiffness_;
  TractionKernels tractions_;
  Index densities_ = 0;
};

}  // namespace epafi::bem
