#pragma once

#include "bem/fields/Interior.hpp"
#include "bem/space/DisplacementField.hpp"

#include <optional>
#include <vector>

namespace epafi::drivers {

/// Displacement and stress on the boundary itself, dimensionless and without a particular solution.
///
/// The traction is the density ψ; along the surface σ_τ = 2μ/(1-ν) ε_τ + ν/(1-ν) ψ·n, ν the
/// plane-strain ratio; of solids of revolution σ_τ and σ_θ = 2μ/(1-ν) (ε_τ + ν ε_θ, ε_θ + ν ε_τ) +
/// ν/(1-ν) ψ·n, ε_θ = u_r/r.  On an axis of revolution they are those of the inside.  The strain
/// ε_τ = du/ds·τ is that of the polynomial through its values at the Gauss points of the element and the
/// nearest two of both neighbours, where derivatives of degree p are right to one order more; a surface
/// that crosses the axis at a right angle has its image there.  Beyond corners and ends of boundaries
/// there are no neighbours.
class SurfaceField {
 public:
  /// Refers to the space and to u.
  SurfaceField(const bem::Space& space, const bem::Lame& lame, const bem::Vector& u,
               bem::Vector psi);

  /// \pre -1 <= t <= 1
  bem::InteriorValue at(int element, double t) const;
  /// ε_τ
  double strainAlong(int element, double t) const;
  /// ε_θ; of plane bodies 0
  double strainAround(int element, double t) const;

 private:
  struct Samples {
    bem::Vector places;  ///< t, beyond [-1, 1] on neighbours
    bem::Vector strains;
  };
  void addNeighbour(int element, bool next, Samples& samples) const;

  const bem::Space& space_;
  bem::Lame lame_;
  bem::Vector psi_;
  bem::DisplacementField u_;
  std::vector<Samples> own_;             ///< of each element
  std::vector<Samples> all_;             ///< with those of neighbours
  std::optional<bem::Interior> inside_;  ///< of solids of revolution
};

}  // namespace epafi::drivers
