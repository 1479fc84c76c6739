#pragma once

#include "bem/base/Material.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/opposite/Opposite.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// The contact of all bodies, all of it that needs no operators: gap g_i = <g, χ_i> and data of
/// the laws for the condensed problem, dimensionless.
struct Obstacle {
  MultiplierSpace multiplier;
  std::shared_ptr<const Opposite> opposite;
  Vector gap{};  ///< per normal coefficient
  /// Per coefficient: <g, χ_i> on bonded sides; tangential ones also <m, χ_i>, m the given
  /// sliding of the opposite side.
  Vector jump{};
  std::vector<Tangential> tangentials{};
  Surface surface{};  ///< compliance of the surfaces
  Vector slid{};      ///< m at the Gauss points of the elements
  Vector wear{};      ///< n k there: worn depth per pressure and slip

  /// What gaps and jumps are of r, the penetration, and body loads,
  ///
  ///   ∫ χ_i d · (u_p - u_p∘P) ds,
  ///
  /// u_p the particular solutions of the body and of the opposite one, P the projection onto that one.
  ///                                                           [doc/theory/body-loads.md]
  Vector given() const;
};

/// \throws bem::InputError if a field of a law is negative or not finite, naming boundary and
/// point, and where a normal law does not go with the basis or with a bond.
Obstacle makeObstacle(const MultiplierSpace& multiplier,
                      const std::shared_ptr<const Opposite>& opposite, bem::Units units);

}  // namespace epafi::contact
