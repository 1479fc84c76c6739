#pragma once

#include "contact/newton/Factoring.hpp"
#include "contact/newton/KeptFactor.hpp"

namespace epafi::contact {

/// By the factor in a memory, brought up to date.  Solutions want refinement, and may not
/// converge.
///
/// Refers to the reduction.  Null where the system is not D and G alone, whatever the point is,
/// and where the memory's factor and a new one are of no use.  \pre D is formed.
std::unique_ptr<const Factoring> keptFactoring(const Reduction& reduction,
                                               FactorMemory& memory);

}  // namespace epafi::contact
