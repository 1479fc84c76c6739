#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "contact/multiplier/MultiplierBasis.hpp"

namespace epafi::contact {

/// Polynomials on [-1, 1] in a multiplier's basis from their values at as many places as
/// the basis has functions.
class Collocation {
 public:
  /// \pre `places` differ; there are as many as coefficients, one more than the degree.
  /// \throws bem::NumericalError if the basis is none.
  Collocation(const MultiplierBasis& basis, bem::Vector places);

  const bem::Vector& places() const { return places_; }

  /// Coefficients of the polynomial with these values at the places.
  bem::Vector coefficients(bem::Vector values) const;

  /// E_kj = χ_j at place k, and what makes coefficients of values.
  bem::Matrix values() const { return values_.copy(); }
  bem::Matrix inverse() const;

 private:
  bem::Vector places_;
  bem::Matrix values_;  // of the basis at the places, a row each
  bem::LuFactor factor_;
};

}  // namespace epafi::contact
