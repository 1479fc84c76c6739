#pragma once

#include "bem/base/Matrix.hpp"

#include <array>

namespace epafi::adaptivity {

using bem::Vector;

/// Where an error comes from, in the order of [P] sec. 8 and of history.csv.
enum class Source {
  Neumann,          ///< f - S u on Neumann sides and in free components of clamps
  Contact,          ///< λ + S u
  Density,          ///< d/ds (V ψ - (K + 1/2) u)
  Complementarity,  ///< λₙ⁺ (g - uₙ)⁺
  Penetration,      ///< (g - uₙ)⁻
  Tension,          ///< λₙ⁻
  Bound,            ///< (|λₜ| - s)⁺
  Slip              ///< (s - |λₜ|)⁺ |uₜ| + |λₜ| |uₜ| - λₜ uₜ
};
constexpr int sourceCount = 8;

/// One nonnegative number per source.
using Contributions = std::array<double, sourceCount>;

inline double& of(Contributions& contributions, Source source) {
  return contributions[static_cast<std::size_t>(source)];
}

/// Squared error indicators, each contribution of each element kept apart.
struct Indicators {
  std::vector<Contributions> squares;  ///< one per element

  /// Ξ²(E) of all elements.
  Vector elements() const;
  /// Sums over the elements.
  Contributions sums() const;
  /// The root of the sum of everything.
  double estimate() const;
};

/// For each element the contributions of those whose sum on it is largest; of one mesh, at
/// least one.
Indicators largest(const std::vector<Indicators>& all);

}  // namespace epafi::adaptivity
