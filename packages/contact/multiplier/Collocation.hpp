#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

namespace epafi::contact {

/// Interpolation on [-1, 1] in a multiplier basis, at as many points as the basis has
/// functions.
class Collocation {
 public:
  /// \param places q + 1 distinct points for the basis of degree q
  /// \throws bem::NumericalError if the functions are linearly dependent
  Collocation(const MultiplierBasis& basis, bem::Vector places);

  const bem::Vector& places() const { return places_; }

  /// E⁻¹ values: coefficients of the polynomial with these values at places().
  bem::Vector coefficients(bem::Vector values) const;

  /// E_kj = χ_j(t_k), t_k = places()[k], and E⁻¹.
  bem::Matrix values() const { return values_.copy(); }
  bem::Matrix inverse() const;

 private:
  bem::Vector places_;
  bem::Matrix values_;  // E
  bem::LuFactor factor_;
};

}  // namespace epafi::contact
