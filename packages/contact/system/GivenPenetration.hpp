#pragma once

#include "contact/body/Loads.hpp"
#include "contact/opposite/Obstacle.hpp"
#include "contact/opposite/TraceCoupling.hpp"

namespace epafi::contact {

/// Adds to r the share of body loads, those of the multipliers' conditions,
///
///   ∫ χ_i d · (u_p - u_p∘P) ds,
///
/// u_p the particular solutions of the body and of the opposite one, P the projection onto that one.
///                                                             [doc/theory/body-loads.md]
void addBodyLoads(const Obstacle& obstacle, Vector& r);

/// Adds to r what the rigid part of the prescribed displacement of a body does on all multipliers.
/// \param own, opposite see motionsOnContacts
void addRigidPart(const Loads& loads, const TraceCoupling& own,
                  const TraceCoupling& opposite, Vector& r);

}  // namespace epafi::contact
