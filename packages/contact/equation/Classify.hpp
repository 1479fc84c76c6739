#pragma once

#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// State of each coefficient of a multiplier: closed if λ + c r > 0 (c: see Equation), slip if
/// |λ + c r| >= s > 0.
/// \param penetration r, by displacements where available (see Configuration): on slender
/// bodies
///   rounding errors of D λ would change states
ContactStates classify(const Problem& problem, const State& state,
                       const Vector& penetration);

/// Frictional work λₜ,i rₜ,i >= 0 of each tangential coefficient, dimensionless; zero
/// unless it
/// slips.                                                      [doc/theory/paths.md, Energies]
Vector frictionWork(const Problem& problem, const State& state,
                    const Vector& penetration);

}  // namespace epafi::contact
