#pragma once

#include "bem/fields/RingInterior.hpp"
#include "bem/mesh/Surfaces.hpp"
#include "contact/conditions/ConductedHeat.hpp"
#include "contact/conditions/RingSources.hpp"

#include <array>

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
  using Series = bem::LegendreSeries<double>;
  /// An element, divided where it is long beside its distance from the axis.
  struct Part {
    int element = 0;
    double from = -1;  ///< of the element
    double to = 1;
    Series temperature{};  ///< T and q as they were given
    Series flow{};
    Series rest{};  ///< ∂Ψ/∂z
    Series restSlope{};  ///< along the surface
    Series restFlow{};
    Series around{};     ///< S/r²
    Series potential{};  ///< Ψ
  };
  static std::vector<Part> partsOf(const bem::Mesh& mesh);
  static bem::Mesh meshOf(const bem::Mesh& mesh, const std::vector<Part>& parts, int more);
  void take(const bem::Space& space, const bem::Vector& data);
  void follow();
  void integrateFlow(std::size_t surface);
  double integrateSlope(std::size_t surface);
  void addSources(const Places& places);
  void addDipoles(const Places& places);
  void addLine();
  void takeOffFree();
  void compare(const bem::Mesh& mesh);
  bem::LocalField fieldOf(std::size_t part, bool isPotential) const;
  bem::Vec2 freeAt(bem::Vec2 y) const;

  std::vector<Part> parts_;
  bem::Mesh mesh_;  ///< of the parts
  std::vector<std::size_t> firsts_;     ///< by element its first part
  std::vector<bem::Surface> surfaces_;  ///< of parts
  bem::Vector flowStarts_;              ///< S and Ψ where the surfaces start
  bem::Vector potentialStarts_;
  bem::Vector gains_;  ///< of Ψ around closed surfaces, spread over them
  std::array<double, 2> free_{};  ///< c₀, c₁
  RingSources sources_;
  bem::Vector missed_;
  std::vector<bem::RingInterior> inside_;  ///< ∂Ψ/∂z, Ψ
};

}  // namespace epafi::contact
