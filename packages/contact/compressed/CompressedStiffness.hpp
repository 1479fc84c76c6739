#pragma once

#include "bem/compressed/CompressedOperators.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/compressed/CompressedCoupling.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

class Opposite;

/// One of the bodies whose operators are compressed together.
struct CompressedInput {
  const bem::Space& space;
  const MultiplierSpace& multiplier;
  const bem::Lame& lame;
  const Opposite* opposite = nullptr;  ///< null: no opposite body
};

/// Coupling of all multipliers with all bodies; coefficients in the order of Numbering.
CompressedCoupling makeCompressedCoupling(const std::vector<CompressedInput>& bodies,
                                          const Stabilization& stabilization,
                                          bem::Units units);

/// Compressed operators of a contact problem, whose unknowns are displacements, densities
/// and the multiplier,
///
///   [ W      K'      B₀ᵀ ]
///   [ K    -(V+G)   -N   ]        λ = 0 where it is held,
///   [ B₀    -Nᵀ     -M   ]
///
/// W, K and V block diagonal by bodies, B₀ with the mortar coupling to opposite bodies;
/// G, N and M of Form Density, zero under Form None.  One per body.
///                                                       [doc/theory/compression.md]
/// \throws bem::InputError for another form
std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<CompressedInput>& bodies, const Stabilization& stabilization,
    bem::Units units, const bem::Processes& processes, const bem::Compression& options);

/// Reason why a stiffness cannot be compressed; empty: it can.
std::string whyNotCompressed(const Stabilization& stabilization);

}  // namespace epafi::contact
