#pragma once

#include "bem/base/Material.hpp"
#include "bem/mesh/Mesh.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// What acts inside a body, dimensionless, in the outline's scaled coordinates z = x + iy.
struct BodyLoads {
  /// The force per volume is uniform + linear z: weight; ρω² - iργ of a spin ω with the angular
  /// acceleration γ, about the origin.
  bem::Complex uniform{};
  bem::Complex linear{};
  /// c z^a z̄^b
  struct Term {
    int a = 0;
    int b = 0;
    bem::Complex c;
  };
  using Terms = std::vector<Term>;
  Terms temperature{};  ///< above the stress-free state, a real sum [temperature]
  double expansion = 0;  ///< α of plane stress, (1+ν) α of plane strain [1 / temperature]
  double across = 0;  ///< σzz of a 1 of temperature that nothing but ν (σxx + σyy) joins
};

/// A displacement u and its stress σ that a BodyLoads has in any body of the material, as
/// polynomials: div σ + b = 0, so that only what the boundary has besides is left to the boundary
/// operators: u is a particular solution, nothing of the inside is discretised.  It has two parts,
/// of forces and of heat; a harmonic temperature has no stress in the plane.
///
/// Dimensionless, in the outline's scaled coordinates; regular at ν = 1/2.
///                                                             [doc/theory/body-loads.md]
class ParticularSolution {
 public:
  ParticularSolution(const BodyLoads& loads, const bem::Lame& lame);

  struct Stress {
    double xx = 0;
    double yy = 0;
    double xy = 0;

    bem::Vec2 on(bem::Vec2 normal) const {
      return {xx * normal.x + xy * normal.y, xy * normal.x + yy * normal.y};
    }
  };
  bem::Vec2 displacement(bem::Vec2 at) const;
  Stress stress(bem::Vec2 at) const;
  /// Per volume.
  bem::Vec2 force(bem::Vec2 at) const;
  /// ½ σ : C⁻¹ σ in the plane, per volume.
  double energyDensity(bem::Vec2 at) const;
  double temperature(bem::Vec2 at) const;
  /// What heat adds to σzz = ν (σxx + σyy) in plane strain.
  double stressAcross(bem::Vec2 at) const { return loads_.across * temperature(at); }

  /// Of the parts alone.
  bem::Vec2 displacementOfForces(bem::Vec2 at) const;
  Stress stressOfHeat(bem::Vec2 at) const { return stressOf(heat_, at); }

  /// On an element's boundary, t in [-1, 1].
  bem::Vec2 displacement(const bem::Mesh& mesh, int element, double t) const {
    return displacement(mesh.scaledPoint(element, t));
  }
  bem::Vec2 traction(const bem::Mesh& mesh, int element, double t) const {
    return stress(mesh.scaledPoint(element, t)).on(mesh[element].curve.normal(t));
  }

 private:
  struct Part {
    BodyLoads::Terms displacement;  ///< u₁ + i u₂
    BodyLoads::Terms trace;         ///< σxx + σyy
  };
  static Part ofForces(const BodyLoads& loads, const bem::Lame& lame);
  static Part ofHeat(const BodyLoads& loads, const bem::Lame& lame);
  Stress stressOf(const Part& part, bem::Vec2 at) const;

  BodyLoads loads_;
  bem::Lame lame_;
  Part forces_;
  Part heat_;
};

/// None: nothing acts inside.
using Inside = std::shared_ptr<const ParticularSolution>;

}  // namespace epafi::contact
