#pragma once

namespace epafi::bem {

/// A linear elastic, isotropic, homogeneous material in the plane.
struct Material {
  double youngsModulus = 1;    ///< E > 0 [stress]
  double poissonsRatio = 0.3;  ///< -1 < nu <= 1/2 [-]
  bool planeStress = false;    ///< else plane strain
};

/// Lamé's problem made dimensionless, with plane stress turned into the plane strain that
/// has the same equations.  Every constant is written without 1/(1-2nu).
///                                                             [doc/theory/operators.md]
struct Lame {
  double nu;  ///< the plane-strain Poisson's ratio
  double mu;  ///< shear modulus / reference stress
  double a;   ///< A = (3-4nu) / (8 pi mu (1-nu)):  G = A (-log r I + c2 d d'/r²)
  double b;   ///< B = A c2 = 1 / (8 pi mu (1-nu))
  double d;   ///< D = mu / (2 pi (1-nu)):  V* = D (-log r I + d d'/r²)

  /// By itself, stresses in Young's moduli. \throws InputError if nu is not in (-1, 1/2].
  explicit Lame(const Material& material) : Lame(material, material.youngsModulus) {}
  /// Stresses in a reference that bodies share.
  Lame(const Material& material, double stress);
};

/// What a dimensionless 1 means to the user.
///
/// Everything inside bem and contact is dimensionless: lengths and displacements are
/// divided by a length, by itself the outline's diameter, stresses by a stress, by itself
/// Young's modulus; bodies that meet share both.  A scene in Pa and m and the same in MPa
/// and mm then run through the same numbers.                   [doc/theory/operators.md]
struct Units {
  double length = 1;  ///< Outline::scaling's
  double stress = 1;  ///< Lame's reference
};

}  // namespace epafi::bem
