#pragma once

#include "bem/fields/CauchyIntegral.hpp"
#include "bem/mesh/Surfaces.hpp"
#include "bem/space/Space.hpp"
#include "contact/conditions/ConductedHeat.hpp"

#include <optional>
#include <vector>

namespace epafi::contact {

/// ConductedHeat of a body in the plane from its values T and flows q on the boundary,
///
///   T = Re f + Σ A log|z-a| + Re C/(z-a),
///
/// f analytic and so that ∫ f dz has one value at a point, too: a source and a dipole in each hole
/// have what T and ∫ f dz gain around it.  Of f and ∫ f dz Cauchy's integrals are what counts, so
/// that both fit to each other whatever T and q err by; each is discrete by that only.
///
///                                                             [doc/theory/body-loads.md]
class PlaneHeat final : public ConductedHeat {
 public:
  /// Where a source and a dipole of each hole are shared out to: its middle, of a slot its middle
  /// line.
  using Places = std::vector<std::vector<bem::Complex>>;
  static Places placesInHoles(const bem::Outline& outline);

  /// `errors`: by element ∫ |T - given|² and its like, of what is interpolated of the data.
  PlaneHeat(const bem::Space& space, const bem::Vector& data, const Places& places,
            bem::Vector errors);

  std::vector<Value> at(const std::vector<bem::Vec2>& points) const override;
  Value on(int element, double t) const override;
  double missed(int element) const override { return missed_[bem::at(element)]; }

 private:
  /// Of the sources at z, where Φ is what has ∇²Φ = T of theirs.
  struct OfSources {
    double temperature = 0;
    bem::Complex slope;         ///< f' of T = Re f
    double potential = 0;       ///< Φ
    bem::Complex gradient;      ///< ∇Φ = 2 ∂Φ/∂z̄
    bem::Complex secondSlopes;  ///< 8 ∂²Φ/∂z̄²
  };
  OfSources ofSources(bem::Complex z) const;
  static Value whole(const OfSources& of, double temperature, bem::Complex integral);

  using Series = bem::CauchyIntegral::Series;
  struct Source {
    bem::Complex place;
    double strength = 0;  ///< A
    bem::Complex dipole;  ///< C
  };
  using Pair = std::array<Series, 2>;
  void startDensities(const bem::Mesh& mesh, const std::vector<bem::Surface>& loops,
                      const Places& places, std::vector<Pair>& densities);
  std::vector<Pair> densities(const bem::Mesh& mesh,
                              const std::vector<bem::Surface>& loops,
                              const Places& places);
  void follow(const std::vector<bem::Surface>& loops);

  std::vector<Source> sources_;
  std::vector<Series> temperatures_;  ///< T and q as they were given
  std::vector<Series> flows_;
  std::vector<Series> integrals_;  ///< ∫ f dz on the boundary, interpolated
  bem::Vector missed_;
  std::optional<bem::CauchyIntegral> cauchy_;
};

}  // namespace epafi::contact
