#pragma once

#include "drivers/run/SolvedStep.hpp"

#include <string>

namespace epafi::drivers {

/// "all of 'fit' slips: at these pressures its friction holds at most 1349.4, a moment of 13494.  ", of each
/// contact whose shear is at its bound wherever it is closed; a moment, about the contact's middle, where it
/// goes all around.  Empty if there is none.
std::string frictionLimits(const SolvedStep& step);

}  // namespace epafi::drivers
