#pragma once

#include "bem/base/Matrix.hpp"

#include <array>

namespace epafi::adaptivity {

using bem::Vector;

/// Terms of the error estimate, in the order of [P] sec. 8 and of history.csv.
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

/// One number >= 0 per source.
using Contributions = std::array<double, sourceCount>;

inline double& of(Contributions& contributions, Source source) {
  return contributions[static_cast<std::size_t>(source)];
}

/// Squared error indicators by element and source.
struct Indicators {
  std::vector<Contributions> squares;  ///< one per element

  /// Ξ²(E), one per element: sums over the sources.
  Vector elements() const;
  /// Sums over the elements, one per source.
  Contributions sums() const;
  /// Error estimate: square root of the sum over elements and sources.
  double estimate() const;
};

/// For each element the contributions of the indicators whose Ξ²(E) is largest.
/// \pre at least one; all on one mesh
Indicators largest(const std::vector<Indicators>& all);

}  // namespace epafi::adaptivity
