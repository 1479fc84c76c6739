#pragma once

#include "bem/space/Space.hpp"
#include "contact/conditions/Conditions.hpp"

#include <vector>

namespace epafi::adaptivity {

/// Does a function on [-1, 1] with these Legendre coefficients look analytic?
///
/// The least squares slope m of |log|a_i|| = m i + b satisfies e^(-m) <= threshold.
/// Coefficients below `floor` count as floor; a series that never exceeds it, or of one
/// term, has nothing to decide from and says yes.
///                                          [P Alg. 25 (d); Houston & Süli 2005]
///
/// Here |log| is -log: a function's unit does not matter.
bool decays(const bem::Vector& coefficients, double floor, double threshold);

/// Algorithm 25's choice for each element: true where raising the degree should pay,
/// because every component of u that is not prescribed and every component of ψ where u
/// is prescribed decays.  Rounding (1e-13 of the largest coefficient on the boundary) is
/// no information.
std::vector<bool> looksAnalytic(const bem::Space& space,
                                const contact::Conditions& conditions,
                                const bem::Vector& displacement,
                                const bem::Vector& density, double threshold);

}  // namespace epafi::adaptivity
