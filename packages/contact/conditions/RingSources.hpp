#pragma once

#include "bem/simd/Pack.hpp"
#include "contact/conditions/BodyStress.hpp"

#include <vector>

namespace epafi::contact {

/// Harmonic temperatures of sources outside a solid of revolution, each with a Φ that has ∇²Φ = T;
/// R the distance from the points of a ring of radius a, integrals over a whole turn:
///
///   T = Σ A/8π² ∫ 1/R - C ∂/∂a ∫ 1/R + L log r,     the flow A out of a ring, or a point of the axis,
///   Φ = Σ A/16π² ∫ R - C/2 ∂/∂a ∫ R + L/4 r² (log r - 1).
///
/// With ∇Ψ = (S/r, T), ∂S/∂s = r ∂T/∂n, Ψ gains 4πC/a around a ring, clockwise in (r, z).
///                                                             [doc/theory/body-loads.md]
class RingSources {
 public:
  struct Source {
    bem::Vec2 place;
    double strength = 0;  ///< A
    double dipole = 0;    ///< C
  };
  struct Value {
    double temperature = 0;
    bem::Vec2 slope;       ///< ∇T
    double potential = 0;  ///< Φ
    bem::Vec2 gradient;    ///< ∇Φ
    BodyStress stress;     ///< ∇∇Φ - T
  };

  void add(const Source& source);
  void addLine(double strength) { line_ += strength; }  ///< L
  Value at(bem::Vec2 x) const;

 private:
  /// Eight sources; unused lanes have no strength.
  struct alignas(64) Eight {
    bem::AlignedLane radius{};
    bem::AlignedLane height{};
    bem::AlignedLane strength{};
    bem::AlignedLane dipole{};
  };
  struct Sum;

  std::vector<Eight> rings_;
  std::size_t count_ = 0;
  double line_ = 0;
};

}  // namespace epafi::contact
