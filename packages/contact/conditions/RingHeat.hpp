#pragma once

#include "bem/fields/RingInterior.hpp"
#include "contact/conditions/ConductedHeat.hpp"
#include "contact/conditions/RingPotential.hpp"

namespace epafi::contact {

/// ConductedHeat of a solid of revolution from its values T and flows q on the surface:
///
///   T = c₀ + c₁ z + sources + ∂Ψ/∂z,   ∇Ψ = (S/r, ∂Ψ/∂z) harmonic,   ∂S/∂s = r ∂²Ψ/∂n∂z,
///
/// of which the first two need no stress, and z Ψ/2 is a Φ of the last one.  On the surface S and Ψ
/// are integrals along it of what is left of q and T, without singularities at corners; inside
/// Ψ and its derivatives are those of Laplace's equation for that.  A source in each hole has the heat
/// that flows through it, a dipole what Ψ gains around it; a line on the axis of a body off it what S
/// gains along it.                                              [doc/theory/body-loads.md]
class RingHeat final : public ConductedHeat {
 public:
  /// Where the source and the dipole of each hole are shared out to: its middle; of one at the axis a
  /// point there.
  using Places = std::vector<std::vector<bem::Complex>>;
  /// \param mesh  of the body: holes are numbered by its surfaces
  static Places placesInHoles(const bem::Mesh& mesh);

  /// `errors`: by element ∫ |T - given|² and its like, of what is interpolated of the data.
  RingHeat(const bem::Space& space, const bem::Vector& data, const Places& places,
           bem::Vector errors);

  std::vector<Value> at(const std::vector<bem::Vec2>& points) const override;
  Value on(int element, double t) const override;
  double missed(int element) const override { return missed_[bem::at(element)]; }

 private:
  const std::vector<RingPotential::Part>& parts() const { return surface_.parts(); }
  const bem::Mesh& mesh() const { return surface_.mesh(); }
  const std::vector<bem::Surface>& surfaces() const { return surface_.surfaces(); }
  void follow() { surface_.follow(sources_, free_); }
  void addSources(const Places& places);
  void addDipoles(const Places& places);
  void addLine();
  void takeOffFree();
  void compare(const bem::Mesh& mesh);
  bem::LocalField fieldOf(std::size_t part, bool isPotential) const;
  bem::Vec2 freeAt(bem::Vec2 y) const;

  RingPotential surface_;
  std::vector<std::size_t> firsts_;  ///< by element its first part
  RingPotential::Free free_{};
  RingSources sources_;
  bem::Vector missed_;
  std::vector<bem::RingInterior> inside_;  ///< ∂Ψ/∂z, Ψ
};

}  // namespace epafi::contact
