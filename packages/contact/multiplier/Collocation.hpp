#pragma once

#include "contact/multiplier/MultiplierBasis.hpp"

namespace epafi::contact {

/// Polynomials on [-1, 1] in a multiplier's basis from their values at as many places as
/// the basis has functions.
class Collocation {
 public:
  /// \pre `places` differ; there are as many as coefficients, one more than the degree.
  Collocation(const MultiplierBasis& basis, bem::Vector places);

  const bem::Vector& places() const { return places_; }

  /// Coefficients of the polynomial with these values at the places.
  /// \throws bem::NumericalError if the basis is none.
  bem::Vector coefficients(bem::Vector values) const;

  /// T with (T c)_i = coefficients of the polynomial that is f_k Σ_j c_j χ_j at place k:
  /// what a factor makes of coefficients.
  /// \throws bem::NumericalError if the basis is none.
  bem::Matrix product(const bem::Vector& factor) const;

 private:
  bem::Vector places_;
  bem::Matrix values_;  // of the basis at the places, a row each
};

}  // namespace epafi::contact
