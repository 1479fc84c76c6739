#pragma once

#include "bem/compressed/CompressedOperators.hpp"
#include "contact/problem/StabilisedBody.hpp"

namespace epafi::contact {

/// The compressed operators of a contact problem: with displacements and densities its
/// multiplier is an unknown,
///
///   [ W      K'      B₀ᵀ ]
///   [ K    -(V+G)   -N   ]        λ = 0 where it is held,
///   [ B₀    -Nᵀ     -M   ]
///
/// G, N and M of Form Density, zero under Form None.       [doc/theory/compression.md]
/// \throws bem::InputError for another form, or where the outline has arcs.
bem::SteklovPoincare makeCompressedStiffness(const bem::Space& space,
                                             const MultiplierSpace& multiplier,
                                             const Stabilization& stabilization,
                                             const bem::Lame& lame, bem::Units units,
                                             const bem::DenseAlgebra& algebra,
                                             const bem::Compression& options);

/// Why a body's stiffness cannot be compressed; empty: it can.
std::string whyNotCompressed(const bem::Outline& outline,
                             const Stabilization& stabilization);

/// \pre input.stiffness is one of these.
std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const ContactProblem::Input& input, const MultiplierSpace& multiplier);

}  // namespace epafi::contact
