#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Vec2.hpp"
#include "bem/space/Space.hpp"

#include <functional>

namespace epafi::reference {

/// A symmetric stress tensor of the plane, in units of Young's modulus.
struct PlaneStressTensor {
  double xx = 0;
  double yy = 0;
  double xy = 0;

  /// The traction sigma n on a line with unit normal n.
  bem::Vec2 operator*(bem::Vec2 n) const {
    return {xx * n.x + xy * n.y, xy * n.x + yy * n.y};
  }
};

/// A solution of the homogeneous equations of plane elasticity, dimensionless as
/// everything in bem: functions of a scaled point, E = 1.
struct ExactField {
  std::function<bem::Vec2(bem::Vec2)> displacement;
  std::function<PlaneStressTensor(bem::Vec2)> stress;
};

/// Constant stress sigma:  u = eps x,  eps = (sigma - nu tr(sigma) I) / (2 mu), plus a
/// rigid rotation.  Bounded as nu -> 1/2.
ExactField constantStress(const bem::Lame& lame, PlaneStressTensor sigma,
                          double rotation = 0);

/// A force e at x0, outside the body:  u = G(x - x0) e,  d = x - x0,  r = |d|,
///
///   u     = A (-log r) e + B d (d.e)/r²,
///   sigma = [ (1-2nu) ((d.e) I - d e' - e d') - 2 dd' (d.e)/r² ] / (4 pi (1-nu) r²).
///
/// The stress is Hooke's law of grad u, not the kernel K' of the code under test.
ExactField pointForce(const bem::Lame& lame, bem::Vec2 x0, bem::Vec2 e);

/// The coefficients of the field's displacement: bem::Space::interpolate.
bem::Vector displacementOf(const bem::Space& space, const ExactField& field);

/// The coefficients of the best approximation in L² of the field's traction on the
/// boundary.
bem::Vector tractionOf(const bem::Space& space, const ExactField& field);

/// L² norm over the boundary of a density minus the field's traction, divided by the norm
/// of that traction.
double tractionError(const bem::Space& space, const bem::Vector& psi,
                     const ExactField& field);

}  // namespace epafi::reference
