#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/StabilisedBody.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

#include <memory>

namespace epafi::contact {

/// A body of makeCompressedStiffness.  \pre input.stiffness is one of these.
std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const BodyInput& input, const MultiplierSpace& multiplier);

}  // namespace epafi::contact
