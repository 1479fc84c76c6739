#pragma once

#include "bem/algebra/LuFactor.hpp"

namespace epafi::bem {

/// Low-rank correction U S Uᵀ of a symmetric A by a projection P = I - R Gᵀ (columns R, G):
///
///   Pᵀ A P - A = U S Uᵀ,   U = (G, A R),   S = [κ, -I; -I, 0],   κ = Rᵀ A R
struct LowRank {
  Matrix u;
  Matrix inverse;  ///< S⁻¹ = [0, -I; -I, -κ]

  LowRank() = default;
  LowRank(Matrix u, const Matrix& kappa);

  /// Y += U S Uᵀ X
  void addTo(Matrix& y, const Matrix& x) const;
};

/// Woodbury's formula (A + U S Uᵀ)⁻¹ b = y - Y (S⁻¹ + Uᵀ Y)⁻¹ Uᵀ y,   y = A⁻¹ b,  Y = A⁻¹ U.
class Woodbury {
 public:
  Woodbury() = default;
  /// \throws NumericalError if A + U S Uᵀ is singular; the message has `name`.  answers: Y
  Woodbury(Matrix u, Matrix inverse, Matrix answers, const char* name);

  /// Replaces x = A⁻¹ B by (A + U S Uᵀ)⁻¹ B.
  void correct(Matrix& x) const;

 private:
  Matrix u_;
  Matrix answers_;  ///< Y
  LuFactor rest_;   ///< of S⁻¹ + Uᵀ Y
};

}  // namespace epafi::bem
