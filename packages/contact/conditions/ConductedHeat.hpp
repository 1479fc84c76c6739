#pragma once

#include "bem/fields/CauchyIntegral.hpp"
#include "bem/space/Space.hpp"

#include <optional>
#include <vector>

namespace epafi::contact {

/// A harmonic temperature inside a body from its values T and flows q on the boundary,
///
///   T = Re f + Σ A log|z-a| + Re C/(z-a),
///
/// f analytic and so that ∫ f dz has one value at a point, too: a source and a dipole in each hole
/// have what T and ∫ f dz gain around it.  Of f and ∫ f dz Cauchy's integrals are what counts, so
/// that both fit to each other whatever T and q err by; each is discrete by that only.
///
/// In the outline's scaled coordinates; temperatures as they are given.
///                                                             [doc/theory/body-loads.md]
class ConductedHeat {
 public:
  /// Where a source and a dipole of each hole are shared out to: its middle, of a slot its middle
  /// line.
  using Places = std::vector<std::vector<bem::Complex>>;
  static Places placesInHoles(const bem::Outline& outline);

  /// `errors`: by element ∫ |T - given|² and its like, of what is interpolated of the data.
  ConductedHeat(const bem::Space& space, const bem::Vector& data, const Places& places,
                bem::Vector errors);

  struct Value {
    double temperature = 0;
    bem::Complex integral;  ///< ∫ f dz
  };
  /// At points inside.
  std::vector<Value> at(const std::vector<bem::Vec2>& points) const;
  /// ∫ f dz on the boundary, interpolated.
  bem::Complex integral(int element, double t) const;
  /// T and q as they were given.
  double temperature(int element, double t) const;
  double flow(int element, double t) const;

  /// Of the sources at z, where Φ is what has ∇²Φ = T of theirs.
  struct OfSources {
    double temperature = 0;
    bem::Complex slope;         ///< f' of T = Re f
    double potential = 0;       ///< Φ
    bem::Complex gradient;      ///< ∇Φ = 2 ∂Φ/∂z̄
    bem::Complex secondSlopes;  ///< 4 ∂²Φ/∂z̄²
  };
  OfSources ofSources(bem::Complex z) const;

  /// ∫ |f - given f|² ds of an element: by how much it misses what it is made from.
  double missed(int element) const { return missed_[bem::at(element)]; }

 private:
  using Series = bem::CauchyIntegral::Series;
  struct Source {
    bem::Complex place;
    double strength = 0;  ///< A
    bem::Complex dipole;  ///< C
  };
  struct Loop {
    std::vector<int> elements;
    double length = 0;
  };
  using Pair = std::array<Series, 2>;
  static std::vector<Loop> loopsOf(const bem::Mesh& mesh);
  void startDensities(const bem::Mesh& mesh, const std::vector<Loop>& loops,
                      const Places& places, std::vector<Pair>& densities);
  std::vector<Pair> densities(const bem::Mesh& mesh, const std::vector<Loop>& loops,
                              const Places& places);
  void follow(const std::vector<Loop>& loops);

  std::vector<Source> sources_;
  std::vector<Series> temperatures_;
  std::vector<Series> flows_;
  std::vector<Series> integrals_;
  bem::Vector missed_;
  std::optional<bem::CauchyIntegral> cauchy_;
};

}  // namespace epafi::contact
