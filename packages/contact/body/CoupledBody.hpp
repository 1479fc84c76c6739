#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/StabilisedBody.hpp"

namespace epafi::contact {

/// The forms that fit into a Coupling, where the stiffness is dense: those of [P], which insert
/// the traction S u, the one by the density, and no stabilisation.
std::unique_ptr<const StabilisedBody> makeCoupledBody(const BodyInput& input,
                                                      const MultiplierSpace& multiplier);

}  // namespace epafi::contact
