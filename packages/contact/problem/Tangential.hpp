#pragma once

#include "bem/base/Matrix.hpp"
#include "contact/law/FrictionLaw.hpp"

#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Vector;

/// A number that belongs to a normal coefficient: what its pressure adds to a bound, or
/// the bound's derivative by it.
struct NormalShare {
  Index normal = 0;
  double value = 0;
};

/// A tangential coefficient of the multiplier and what limits it,
///
///   s = law(λ_n, strength),   where `others` are empty, else
///   s = law(λ_n, strength) + Σ law(λ_j, value_j) over them,
///
/// kept within law(λ_n, least) and law(λ_n, most), zero where λ_n is.  Pressures enter
/// through their positive parts.                                  see pressureBound
struct Tangential {
  Index normal = 0;  ///< the normal coefficient at the same place
  const FrictionLaw* law = nullptr;
  double strength = 0;  ///< threshold or coefficient, dimensionless; >= 0 if alone
  /// The other pressures of its element, with strengths of either sign.
  std::vector<NormalShare> others{};
  double least = 0;  ///< only beside others; 0 <= least <= most
  double most = 0;

  /// s >= 0; `pressures` begins with those of all normal coefficients.
  double bound(const Vector& pressures) const;

  /// ds/dλ, zeros left out; at a kink one of its limits.
  std::vector<NormalShare> slopes(const Vector& pressures) const;

  /// A strength that alone bounds s from above, whatever the other pressures.
  double largestStrength() const { return others.empty() ? strength : most; }

  /// The same without others: their strengths are its own, as if one pressure were on all
  /// of the element.
  Tangential uncoupled() const;

  /// With another law's strengths, factor times as large; factor >= 0.
  Tangential scaled(double factor) const;

 private:
  double sum(const Vector& pressures) const;
  const double* alone(const Vector& pressures) const;
};

}  // namespace epafi::contact
