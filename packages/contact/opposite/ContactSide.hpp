#pragma once

#include "bem/space/Space.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// What contact knows of an elastic body without its operators.
struct ContactSide {
  const bem::Space& space;
  const MultiplierSpace& multiplier;
  const Opposite& opposite;
};

}  // namespace epafi::contact
