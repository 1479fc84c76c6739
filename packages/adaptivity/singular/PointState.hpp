#pragma once

#include "contact/equation/ContactState.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::adaptivity {

/// What the place of a multiplier's coefficient does.
struct PointState {
  contact::NormalState normal = contact::NormalState::Open;
  contact::FrictionState friction = contact::FrictionState::None;

  bool operator==(const PointState& other) const {
    return normal == other.normal && friction == other.friction;
  }
  bool operator!=(const PointState& other) const { return !(*this == other); }
};

/// Of coefficient i of an element.  Under a law that follows the pressure an open point
/// has no friction state of its own.
PointState pointState(const contact::MultiplierSpace& multiplier,
                      const contact::MultiplierSpace::ContactElement& element, int i,
                      const contact::ContactState& states);

}  // namespace epafi::adaptivity
