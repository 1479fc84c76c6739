#pragma once

#include "bem/algebra/LuFactor.hpp"

namespace epafi::bem {

/// What a symmetric A loses and gains where some motions R of it go through functionals G:
///
///   Pᵀ A P - A = U S Uᵀ,   P = I - R Gᵀ,   U = (G, A R),   S = [κ, -I; -I, 0],   κ = Rᵀ A R
struct LowRank {
  Matrix u;
  Matrix inverse;  ///< S⁻¹ = [0, -I; -I, -κ]

  LowRank() = default;
  LowRank(Matrix u, const Matrix& kappa);

  /// Y += U S Uᵀ X
  void addTo(Matrix& y, const Matrix& x) const;
};

/// (A + U S Uᵀ)⁻¹ b = y - Y (S⁻¹ + Uᵀ Y)⁻¹ Uᵀ y,   y = A⁻¹ b,  Y = A⁻¹ U: Woodbury's formula.
class Woodbury {
 public:
  Woodbury() = default;
  /// \throws NumericalError where A + U S Uᵀ is singular; `name` is for the message.
  Woodbury(Matrix u, Matrix inverse, Matrix answers, const char* name);

  /// From A⁻¹ B, which it replaces.
  void correct(Matrix& x) const;

 private:
  Matrix u_;
  Matrix answers_;  ///< Y
  LuFactor rest_;   ///< of S⁻¹ + Uᵀ Y
};

}  // namespace epafi::bem
