#pragma once

#include "contact/problem/Numbering.hpp"
#include "contact/system/ContactProblem.hpp"

namespace epafi::contact {

/// How the multipliers of the other bodies of a system act on each body, by mortar traces, their
/// coefficients numbered as the system's; empty: nothing of it is opposite to another one.
/// \throws bem::InputError for a multiplier that shares nodes where contact with another body
///   meets a clamp or another contact side.
std::vector<TraceCoupling> oppositeCouplings(const std::vector<ContactProblem>& bodies,
                                             const Numbering& numbering);

}  // namespace epafi::contact
