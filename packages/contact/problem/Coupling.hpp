#pragma once

#include "bem/assembly/TractionRows.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "contact/problem/Loads.hpp"

namespace epafi::contact {

/// The matrices that couple displacement and multiplier, stabilisation included.
///
///   B_ij = <χ_i, φ_j> - <γ χ_i, S φ_j>,  M_ij = <γ χ_j, χ_i>,  S^_ij = <γ S φ_j, S φ_i>
///                                                                        [design.md 4.1]
struct Coupling {
  Matrix couplingTransposed;  ///< Bᵀ: displacements (mine) x multiplier
  Matrix multiplierMass;      ///< M: multiplier x multiplier, lower triangle, whole
  Matrix
      stabilisationHalf;  ///< X with S^ = X Xᵀ: displacements (mine) x traction columns
  Vector gamma;           ///< per contact element, dimensionless; 0 without stabilisation
};

Coupling makeCoupling(const ContactProblem::Input& input,
                      const MultiplierSpace& multiplier);

/// g_i = <g, χ_i>, dimensionless, and the strengths of the tangential coefficients.
struct Obstacle {
  Vector gap;  ///< per normal coefficient
  std::vector<Tangential> tangentials;
  double largestPenetration = 0;  ///< max of -g
};

/// \throws bem::InputError if a friction strength is negative or not finite, naming
/// boundary and point.
Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      bem::Units units);

}  // namespace epafi::contact
