#pragma once

#include "bem/space/Space.hpp"
#include "contact/opposite/Opposite.hpp"
#include "contact/problem/Numbering.hpp"

#include <vector>

namespace epafi::contact {

/// What contact knows of an elastic body without its operators.
struct ContactSide {
  const bem::Space& space;
  const MultiplierSpace& multiplier;
  const Opposite& opposite;
};

/// Of the multipliers of all bodies.
Numbering numberingOf(const std::vector<ContactSide>& bodies);

}  // namespace epafi::contact
