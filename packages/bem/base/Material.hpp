#pragma once

namespace epafi::bem {

/// A linear elastic, isotropic, homogeneous material in the plane.
struct Material {
  double youngsModulus = 1;    ///< E > 0 [stress]
  double poissonsRatio = 0.3;  ///< -1 < nu <= 1/2 [-]
  bool planeStress = false;    ///< else plane strain
};

/// Dimensionless constants of Lamé's equations; plane stress is converted to the equivalent
/// plane strain.  No constant contains 1/(1-2nu).
///                                                             [doc/theory/operators.md]
struct Lame {
  double nu;  ///< the plane-strain Poisson's ratio
  double mu;  ///< shear modulus / reference stress
  double a;   ///< A = (3-4nu) / (8 pi mu (1-nu)):  G = A (-log r I + c2 d d'/r²)
  double b;   ///< B = A c2 = 1 / (8 pi mu (1-nu))
  double d;   ///< D = mu / (2 pi (1-nu)):  V* = D (-log r I + d d'/r²)

  /// Reference stress E.  \throws InputError if nu is not in (-1, 1/2]
  explicit Lame(const Material& material) : Lame(material, material.youngsModulus) {}
  /// \param stress reference stress; the same for all bodies of a scene
  Lame(const Material& material, double stress);
};

/// Young's modulus E = 2 μ (1 + ν), over the reference stress.
inline double youngOf(const Lame& lame) { return 2 * lame.mu * (1 + lame.nu); }

/// Reference length and stress, in the user's units.
///
/// All quantities in bem and contact are dimensionless: lengths and displacements are divided
/// by a length (of a single body, the diameter of its outline), stresses by a stress (of a
/// single body, Young's modulus); all bodies of a scene share both.  A scene in Pa and m and
/// the same scene in MPa and mm give the same numbers.         [doc/theory/operators.md]
struct Units {
  double length = 1;            ///< length of Outline::scaling()
  double stress = 1;            ///< reference stress of Lame
  bool isAxisymmetric = false;  ///< of a whole revolution, else per unit of thickness

  /// Of Mesh::measure.
  double measure() const { return isAxisymmetric ? length * length : length; }
  double force() const { return stress * measure(); }
  double energy() const { return force() * length; }
};

}  // namespace epafi::bem
