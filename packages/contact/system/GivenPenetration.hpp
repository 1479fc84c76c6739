#pragma once

#include "contact/body/Loads.hpp"
#include "contact/opposite/Obstacle.hpp"
#include "contact/opposite/TraceCoupling.hpp"

namespace epafi::contact {

/// Adds what body b has opposite: its laws and surfaces to a problem, gaps and given jumps to r.
void addObstacle(const Obstacle& obstacle, const Numbering& numbering, std::size_t b,
                 Problem& problem, Vector& r);

/// Adds to r the share of body loads, those of the multipliers' conditions,
///
///   ∫ χ_i d · (u_p - u_p∘P) ds,
///
/// u_p the particular solutions of the body and of the opposite one, P the projection onto that one.
///                                                             [doc/theory/body-loads.md]
void addBodyLoads(const std::vector<ContactSide>& sides, const Numbering& numbering,
                  Vector& r);

/// Adds to r what the rigid part of the prescribed displacement of body b does on all multipliers.
/// \param own, opposite see motionsOnContacts
void addRigidPart(const Loads& loads, const Numbering& numbering, std::size_t b,
                  const TraceCoupling& own, const TraceCoupling& opposite, Vector& r);

}  // namespace epafi::contact
