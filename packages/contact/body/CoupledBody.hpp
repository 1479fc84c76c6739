#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/StabilisedBody.hpp"

namespace epafi::contact {

/// A body with dense stiffness: all forms of the stabilisation, by their Coupling.
/// \pre input.stiffness is formed
std::unique_ptr<const StabilisedBody> makeCoupledBody(const BodyInput& input,
                                                      const MultiplierSpace& multiplier);

}  // namespace epafi::contact
