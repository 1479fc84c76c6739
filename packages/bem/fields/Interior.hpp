#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// Displacement and stress at a point inside the body, dimensionless.
struct InteriorValue {
  Vec2 displacement;
  double xx = 0;
  double yy = 0;
  double xy = 0;
};

/// u = V ψ - K u,  σ n = K' ψ + W u for n = e₁, e₂, all in closed form, so that points
/// next to the boundary are as accurate as far ones. [doc/theory/operators.md]
///
/// `x` is given in the scaled coordinates of the outline and must lie inside.
InteriorValue evaluateInterior(const Space& space, const Lame& lame, const Vector& u,
                               const Vector& psi, Vec2 x);

}  // namespace epafi::bem
