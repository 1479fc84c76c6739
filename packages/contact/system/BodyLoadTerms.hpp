#pragma once

#include "contact/opposite/Numbering.hpp"
#include "contact/system/ContactBody.hpp"

namespace epafi::contact {

/// The share of body loads in r, one number per coefficient of all bodies: ∫ χ_i d · (u_p - u_p∘P) ds, u_p the
/// particular solutions of the body and of the opposite one, P the projection onto that one, and what their
/// tractions add through the stabilisation.  Empty without body loads.      [doc/theory/body-loads.md]
Vector bodyLoadTerms(const std::vector<ContactBody>& bodies, const Numbering& numbering);

}  // namespace epafi::contact
