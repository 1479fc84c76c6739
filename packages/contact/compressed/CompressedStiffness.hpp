#pragma once

#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/opposite/Opposite.hpp"
#include "contact/stabilization/Stabilization.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

/// Compressed operators of a contact problem, whose unknowns are displacements, densities
/// and the multiplier,
///
///   [ W      K'      B₀ᵀ ]
///   [ K    -(V+G)   -N   ]        λ = 0 where it is held,
///   [ B₀    -Nᵀ     -M   ]
///
/// W, K and V block diagonal by bodies, B₀ with the mortar coupling to opposite bodies;
/// G, N and M of Form Density, zero under Form None.  One per body.  Where D is formed, as it is for the
/// sake of beddings, too, the multiplier stays out of the tree, and each of several bodies has a tree of
/// its own, or a dense S where it has a bedding.
///                                                       [doc/theory/compression.md]
/// \param formedUpTo  see BodyInput
/// \throws bem::InputError for another form
std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<const bem::Space*>& spaces, const std::vector<bem::Lame>& lames,
    const MultiplierSpace& multiplier, const Opposite& opposite,
    const Stabilization& stabilization, bem::Units units, const bem::Processes& processes,
    const bem::Compression& options, Index formedUpTo = 1000);

/// Reason why a stiffness cannot be compressed; empty: it can.
std::string whyNotCompressed(const Stabilization& stabilization);

}  // namespace epafi::contact
