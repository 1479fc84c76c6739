#pragma once

#include "contact/opposite/Obstacle.hpp"

namespace epafi::contact {

/// Adds to r the share of body loads, those of the multipliers' conditions,
///
///   ∫ χ_i d · (u_p - u_p∘P) ds,
///
/// u_p the particular solutions of the body and of the opposite one, P the projection onto that one.
///                                                             [doc/theory/body-loads.md]
void addBodyLoads(const Obstacle& obstacle, Vector& r);

}  // namespace epafi::contact
