#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

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
class Interior {
 public:
  /// Refers to the space.
  Interior(const Space& space, const Lame& lame, const Vector& u, const Vector& psi);

  /// Points are given in the scaled coordinates of the outline and must lie inside.
  InteriorValue at(Vec2 x) const { return at(std::vector<Vec2>{x}).front(); }
  /// Eight points take as long as one.  Threads: over the points.
  std::vector<InteriorValue> at(const std::vector<Vec2>& points) const;

 private:
  const Space& space_;
  Lame lame_;
  double rotation_ = 0;  ///< its amount in u
  std::vector<LocalField> fields_;
};

}  // namespace epafi::bem
