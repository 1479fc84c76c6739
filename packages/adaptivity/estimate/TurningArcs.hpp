#pragma once

#include "adaptivity/estimate/ResidualEstimator.hpp"

namespace epafi::adaptivity {

/// Of each of some states of one body the amplitude T of the traction T r on the whole boundary, r of bem::Rotation, which takes off the
/// moment of contact forces on arcs that turn about their centres, where the direction of contact is
/// not their normal; dimensionless.                     [doc/theory/contact.md, Arcs that turn]
///
///   T <r_I, r> = ∫ λ_n turn ds on its own sides - ∫ λ_n turn ds on those that face it
Vector turningTractions(const std::vector<Estimated>& states);

}  // namespace epafi::adaptivity
