#pragma once

#include "bem/base/Material.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/opposite/Opposite.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// g_i = <g, χ_i>, dimensionless, and what limits the tangential coefficients.
struct Obstacle {
  Vector gap;  ///< per normal coefficient
  /// Per coefficient of the multiplier: of bonded sides likewise, of tangential ones <m, χ_i>,
  /// m what slides by.
  Vector jump;
  std::vector<Tangential> tangentials;
  Surface surface;                ///< what the sides yield by
  Vector slid;                    ///< m at the elements' Gauss points
  Vector wear;                    ///< n k there: what a pressure wears off per slip
  double largestSliding = 0;      ///< max of |m|
  double largestPenetration = 0;  ///< max of -g, of |g| where sides are bonded
};

/// \throws bem::InputError if a field of a law is negative or not finite, naming boundary and
/// point, and where a normal law does not go with the basis or with a bond.
Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      const Opposite& opposite, bem::Units units);

}  // namespace epafi::contact
