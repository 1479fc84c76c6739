#pragma once

#include "bem/fields/SourceGroups.hpp"
#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/LegendreSeries.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// Cauchy integrals of two densities f on the boundary:
///
///   F(z) = 1/2πi ∮ f(y) dy / (y - z),      dy = τ ds,
///
/// f a Legendre series on each element.  In closed form, also near the boundary; elements far away
/// by SourceGroups.  If f is the boundary value of an analytic function, F is that function.
///                                                             [doc/theory/body-loads.md]
class CauchyIntegral {
 public:
  using Pair = std::array<Complex, 2>;
  using Series = LegendreSeries<Complex>;

  /// \param densities both series, for each element
  CauchyIntegral(Mesh mesh, std::vector<std::array<Series, 2>> densities);
  CauchyIntegral(const CauchyIntegral&) = delete;
  CauchyIntegral& operator=(const CauchyIntegral&) = delete;

  /// Values at points inside, in scaled coordinates.  Threads: over the points.
  std::vector<Pair> at(const std::vector<Vec2>& points) const;
  /// Limits from inside at points t in (-1, 1) of an element.
  std::vector<Pair> on(int element, const Vector& points) const;

  const Mesh& mesh() const { return mesh_; }
  const std::array<Series, 2>& density(int e) const { return densities_[e]; }

 private:
  static std::vector<int> termsOf(const std::vector<std::array<Series, 2>>& densities);
  void setDensities(int e, const Rule& rule, std::vector<Complex>& g) const;

  Mesh mesh_;
  std::vector<std::array<Series, 2>> densities_;
  std::vector<int> terms_;  ///< by element, number of terms above rounding error
  ElementRuns runs_;        ///< of mesh_
  SourceGroups groups_;     ///< of f τ
};

}  // namespace epafi::bem
