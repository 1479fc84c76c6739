#pragma once

namespace epafi::bem {

/// What a dimensionless 1 means to the user.
///
/// Everything inside bem and contact is dimensionless: lengths and displacements are
/// divided by the outline's diameter, stresses by Young's modulus.  A scene in Pa and m
/// and the same in MPa and mm then run through the same numbers.  [doc/notation.md]
struct Units {
  double length = 1;  ///< the outline's diameter
  double stress = 1;  ///< Young's modulus
};

}  // namespace epafi::bem
