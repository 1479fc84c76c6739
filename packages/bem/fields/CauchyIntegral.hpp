#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/LegendreSeries.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// Two functions that are analytic inside, by values on the boundary:
///
///   F(z) = 1/2πi ∮ f(y) dy / (y - z),      dy = τ ds,
///
/// f a Legendre series on each element; in closed form, near the boundary, too.  Where f is itself
/// the boundary value of an analytic function, F is that.       [doc/theory/body-loads.md]
class CauchyIntegral {
 public:
  using Pair = std::array<Complex, 2>;
  using Series = LegendreSeries<Complex>;

  /// Series of all elements.
  CauchyIntegral(Mesh mesh, std::vector<std::array<Series, 2>> densities);

  /// At points inside, scaled.
  std::vector<Pair> at(const std::vector<Vec2>& points) const;
  /// On the boundary from inside, at points t of (-1, 1) on an element.
  std::vector<Pair> on(int element, const Vector& points) const;

  const Mesh& mesh() const { return mesh_; }
  const std::array<Series, 2>& density(int e) const { return densities_[e]; }

 private:
  Mesh mesh_;
  std::vector<std::array<Series, 2>> densities_;
  std::vector<int> terms_;  ///< of each element's series, that are not rounding
};

}  // namespace epafi::bem
