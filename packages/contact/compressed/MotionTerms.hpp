#pragma once

#include "contact/compressed/CompressedCoupling.hpp"
#include "contact/compressed/CompressedHolding.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// D_M, what D is with springs in place of A⁺, and U S Uᵀ, with which it is D:
///
///   D = D_M - G wᵀ - w Gᵀ + G κ Gᵀ,   w = Ĉ M⁻¹ c,  κ = cᵀ M⁻¹ c,  G = Ĉ R
struct MotionTerms {
  Matrix u;        ///< (G, w); empty without motions
  Matrix inverse;  ///< S⁻¹ = [0, -I; -I, -κ]

  MotionTerms() = default;
  MotionTerms(const CompressedCoupling& coupling,
              const std::vector<std::shared_ptr<const CompressedHolding>>& bodies);

  /// Uᵀ x
  Vector seen(const double* x) const;
  /// S Uᵀ x
  Vector sizes(const double* x) const { return scaled(seen(x)); }
  /// S s, S = [κ, -I; -I, 0]
  Vector scaled(const Vector& sums) const;
};

}  // namespace epafi::contact
