#pragma once

#include "bem/space/Space.hpp"
#include "contact/conditions/Conditions.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Do the Legendre coefficients a_i of a function on [-1, 1] decay as those of an
/// analytic one?
///
/// True if the least squares fit -log|a_i| = m i + b has e^(-m) <= threshold.
/// Coefficients below `floor` count as floor.  Also true if none exceeds it, or for a
/// single coefficient.
///                                          [P Alg. 25 (d); Houston & Süli 2005]
///
/// [P] has |log|a_i||, which depends on the unit of the function.
bool decays(const bem::Vector& coefficients, double floor, double threshold);

/// Criterion of [P] Algorithm 25 for p-refinement, one per element: all components of u
/// that are not prescribed, and those of ψ where u is prescribed, satisfy decays().
/// floor: 1e-13 of the largest entry of u or ψ on the boundary.
std::vector<bool> looksAnalytic(const bem::Space& space,
                                const contact::Conditions& conditions,
                                const bem::Vector& displacement,
                                const bem::Vector& density, double threshold);

}  // namespace epafi::adaptivity
