#pragma once

namespace epafi::bem {

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
