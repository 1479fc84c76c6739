#pragma once

#include "contact/conditions/BodyStress.hpp"

#include <vector>

namespace epafi::contact {

/// A harmonic temperature T = T₀ + ∇²Φ inside a body, from its values and flows on the boundary: T₀
/// needs no stress, of Φ the displacement is m ∇Φ.  In the outline's scaled coordinates;
/// temperatures as they are given.                              [doc/theory/body-loads.md]
class ConductedHeat {
 public:
  struct Value {
    double temperature = 0;    ///< T
    bem::Vec2 free;            ///< what T₀ of expansion 1 moves
    double potential = 0;      ///< Φ
    bem::Vec2 gradient;        ///< ∇Φ
    BodyStress stress;         ///< (∇∇Φ - ∇²Φ), over 2μm
    double stressing = 0;      ///< ∇²Φ
    double flow = 0;           ///< ∂T/∂n, on the boundary only
    double stressingFlow = 0;  ///< ∂∇²Φ/∂n, on the boundary only
  };

  ConductedHeat() = default;
  ConductedHeat(const ConductedHeat&) = delete;
  ConductedHeat& operator=(const ConductedHeat&) = delete;
  virtual ~ConductedHeat() = default;

  /// At points inside; many points in one call are cheapest.
  virtual std::vector<Value> at(const std::vector<bem::Vec2>& points) const = 0;
  /// On the boundary, t in [-1, 1].
  virtual Value on(int element, double t) const = 0;
  /// ∫ |f - given f|² over an element, f as much as T: by how much it misses what it is made from.
  virtual double missed(int element) const = 0;
};

}  // namespace epafi::contact
