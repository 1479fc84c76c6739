#pragma once

#include "bem/base/Material.hpp"
#include "bem/mesh/Mesh.hpp"
#include "contact/conditions/ConductedHeat.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// Body forces and temperature of a body, dimensionless, in scaled coordinates z = x + iy.
struct BodyLoads {
  /// The force per volume is uniform + linear z: weight; ρω² - iργ of a spin ω with the angular
  /// acceleration γ, about the origin.  Of solids of revolution uniform + linear x.
  bem::Complex uniform{};
  bem::Complex linear{};
  /// c z^a z̄^b, of solids of revolution c x^a y^b
  struct Term {
    int a = 0;
    int b = 0;
    bem::Complex c;
  };
  using Terms = std::vector<Term>;
  Terms temperature{};   ///< above the stress-free state, a real sum [temperature]
  double expansion = 0;  ///< α of plane stress, else (1+ν) α [1 / temperature]
  double across = 0;  ///< σzz of a 1 of temperature that nothing but ν (σxx + σyy) joins
  bool isAxisymmetric = false;  ///< a in `temperature` is even
};

/// Particular solution u, σ of div σ + b = 0 for BodyLoads, as polynomials.  The boundary
/// operators solve for the remaining homogeneous part, so that the interior is not discretised.
/// It has two parts, for forces and for heat.  A harmonic temperature has no stress in the plane
/// except that of sources in holes.  For conducted heat the second part is that of ConductedHeat.  Those of solids of revolution are polynomials in x and y.
///
/// Dimensionless, in the outline's scaled coordinates; regular at ν = 1/2.
///                                                             [doc/theory/body-loads.md]
class ParticularSolution {
 public:
  ParticularSolution(const BodyLoads& loads, const bem::Lame& lame);
  /// The same forces with the temperature `heat`.
  ParticularSolution(const ParticularSolution& loads,
                     std::shared_ptr<const ConductedHeat> heat);

  using Stress = BodyStress;
  struct Value {
    bem::Vec2 displacement;
    double temperature = 0;
    Stress stress;
  };
  /// Values at points inside; many points in one call are cheapest.
  std::vector<Value> at(const std::vector<bem::Vec2>& points) const;
  bem::Vec2 displacement(bem::Vec2 place) const { return at({place})[0].displacement; }
  double temperature(bem::Vec2 place) const { return at({place})[0].temperature; }
  Stress stress(bem::Vec2 place) const { return at({place})[0].stress; }
  /// Per volume.
  bem::Vec2 force(bem::Vec2 at) const;
  /// ½ σ : C⁻¹ σ in the plane or around the axis, per volume, of forces and polynomial heat.
  double energyDensity(bem::Vec2 at) const;
  /// Thermal part of σzz in plane strain, in addition to ν (σxx + σyy).
  double stressAcross(double temperature) const { return loads_.across * temperature; }

  /// Displacement of the forces.
  bem::Vec2 displacementOfForces(bem::Vec2 at) const;

  /// Over the body.
  struct Energies {
    double own = 0;   ///< ½ ∫ σ : C⁻¹ σ in the plane or around the axis
    double work = 0;  ///< ∫ b·u
  };
  Energies energies(const bem::Mesh& mesh) const;

  /// On the boundary, t in [-1, 1]; the mesh is that of conducted heat.
  Value on(const bem::Mesh& mesh, int element, double t) const;
  bem::Vec2 displacement(const bem::Mesh& mesh, int element, double t) const;
  bem::Vec2 traction(const bem::Mesh& mesh, int element, double t) const {
    return on(mesh, element, t).stress.on(mesh[element].curve.normal(t));
  }
  /// Stress of the heat.
  Stress stressOfHeat(const bem::Mesh& mesh, int element, double t) const;
  /// Null: heat is a polynomial.
  const ConductedHeat* conducted() const { return conducted_.get(); }
  double expansion() const { return loads_.expansion; }

 private:
  struct Part {
    BodyLoads::Terms displacement;  ///< u₁ + i u₂
    BodyLoads::Terms trace;         ///< σxx + σyy
    BodyLoads::Terms hoop;          ///< of solids of revolution
  };
  static Part ofForces(const BodyLoads& loads, const bem::Lame& lame);
  static Part ofHeat(const BodyLoads& loads, const bem::Lame& lame);
  static Part ofForcesAround(const BodyLoads& loads, const bem::Lame& lame);
  static Part ofHeatAround(const BodyLoads& loads, const bem::Lame& lame);
  bem::Complex sum(const BodyLoads::Terms& terms, bem::Vec2 at) const;
  bem::Complex conjugateSlope(const BodyLoads::Terms& terms, bem::Vec2 at) const;
  Stress stressOf(const Part& part, bem::Vec2 at) const;
  Value ofPolynomials(bem::Vec2 at) const;
  bem::Vec2 displacementOfPolynomials(bem::Vec2 at) const;
  bem::Vec2 displacementOf(const ConductedHeat::Value& heat) const;
  Stress stressOf(const ConductedHeat::Value& heat) const;
  void add(const ConductedHeat::Value& heat, Value& value) const;
  void addConducted(const bem::Mesh& mesh, Energies& energies) const;
  double ofConducted() const { return loads_.expansion / (1 - lame_.nu); }  ///< m
  /// α' of what needs no stress.
  double freely() const {
    return loads_.isAxisymmetric ? loads_.expansion / (1 + lame_.nu) : loads_.expansion;
  }

  BodyLoads loads_;
  bem::Lame lame_;
  Part forces_;
  Part heat_;
  std::shared_ptr<const ConductedHeat> conducted_;
};

/// Null: no body loads.
using BodyLoadSolution = std::shared_ptr<const ParticularSolution>;

}  // namespace epafi::contact
