#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/LocalField.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// Displacement and stress at a point inside the body, dimensionless.
struct InteriorValue {
  Vec2 displacement;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double zz = 0;  ///< hoop stress of a solid of revolution; else not set
};

class RingInterior;

/// Evaluates u = V ψ - K u and σ n = K' ψ + W u, n = e₁, e₂, inside the body in closed form, of solids
/// of revolution as RingInterior; accuracy does not decrease near the boundary.
///                                                        [doc/theory/operators.md]
class Interior {
 public:
  /// Refers to the space.
  Interior(const Space& space, const Lame& lame, const Vector& u, const Vector& psi);

  /// \pre x is inside the body, in scaled coordinates
  InteriorValue at(Vec2 x) const { return at(std::vector<Vec2>{x}).front(); }
  /// Many points cost far less each: elements far from some neighbouring points act on them by
  /// SourceGroups.  Threads: over the points.
  std::vector<InteriorValue> at(const std::vector<Vec2>& points) const;

 private:
  /// What an element does, close to it and far away.
  LocalField field(int e) const { return localField(space_, inner_, psi_, e); }
  void setDensities(int e, const Rule& rule, std::vector<Complex>& g) const;

  const Space& space_;
  Lame lame_;
  Vector inner_;  ///< P u of Rotation
  Vector psi_;
  double rotation_ = 0;                        ///< ω(u) of Rotation
  std::shared_ptr<const RingInterior> rings_;  ///< of solids of revolution
};

}  // namespace epafi::bem
