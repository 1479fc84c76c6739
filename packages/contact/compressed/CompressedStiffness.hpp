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
  const Opposite* opposite = nullptr;  ///< null: it meets no other body
};

/// How all multipliers act on all bodies, numbered as a Numbering does.
CompressedCoupling makeCompressedCoupling(const std::vector<CompressedInput>& bodies,
                                          const Stabilization& stabilization,
                                          bem::Units units);

/// The compressed operators of a contact problem: with displacements and densities its
/// multiplier is an unknown,
///
///   [ W      K'      B₀ᵀ ]
///   [ K    -(V+G)   -N   ]        λ = 0 where it is held,
///   [ B₀    -Nᵀ     -M   ]
///
/// W, K and V of each body beside those of others, B₀ with the traces of what is met; G, N
/// and M of Form Density, zero under Form None.      [doc/theory/compression.md]
/// \throws bem::InputError for another form.
std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<CompressedInput>& bodies, const Stabilization& stabilization,
    bem::Units units, const bem::Processes& processes, const bem::Compression& options);

/// Why a stiffness cannot be compressed; empty: it can.
std::string whyNotCompressed(const Stabilization& stabilization);

}  // namespace epafi::contact
