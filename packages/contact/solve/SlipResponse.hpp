#pragma once

#include "contact/system/ContactSystem.hpp"

namespace epafi::contact {

/// S', see SlipIteration: by how much the slips at the points, of the solution of a step and of those near it
/// with the same states of contact, grow per slip by which the step wears.  Size zero where it has no such
/// neighbours.
bem::Matrix slipResponse(const ContactSystem& system, const Configuration& at);

}  // namespace epafi::contact
