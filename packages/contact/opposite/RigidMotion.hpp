#pragma once

#include "bem/base/Vec2.hpp"

namespace epafi::contact {

/// A small motion of a body that does not deform, `slide` + `turn` e_z x arm, the arm from
/// its reference point.
struct RigidMotion {
  bem::Vec2 slide{};
  double turn = 0;  ///< [radian]

  bem::Vec2 at(bem::Vec2 arm) const { return slide + turn * turnLeft(arm); }
};

}  // namespace epafi::contact
