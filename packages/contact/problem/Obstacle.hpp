#pragma once

#include "bem/base/Units.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/Opposite.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// g_i = <g, χ_i>, dimensionless, and what limits the tangential coefficients.
struct Obstacle {
  Vector gap;  ///< per normal coefficient
  /// <d_i · u, χ_i> of what moves without deforming, per coefficient, the given jump of
  /// bonded sides included.
  Vector motion;
  std::vector<Tangential> tangentials;
  double largestPenetration = 0;  ///< max of -g
  double largestMotion = 0;       ///< |u|
};

/// offset - g - what moves: the obstacle's part of d0.
void takeAway(const Obstacle& obstacle, Vector& offset);

/// \throws bem::InputError if a field of a friction law is negative or not finite, naming
/// boundary and point.
Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      const Opposite& opposite, bem::Units units);

}  // namespace epafi::contact
