#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/StabilisedBody.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

#include <memory>

namespace epafi::contact {

/// One body on compressed operators.  \pre input.stiffness is of makeCompressedStiffness
std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const BodyInput& input, const MultiplierSpace& multiplier);

}  // namespace epafi::contact
