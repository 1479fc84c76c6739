#pragma once

#include "bem/base/Vec2.hpp"

namespace epafi::contact {

/// Stress, or what is like it, in the plane and around an axis of revolution.
struct BodyStress {
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double hoop = 0;  ///< of solids of revolution

  BodyStress operator+(const BodyStress& other) const {
    return {xx + other.xx, yy + other.yy, xy + other.xy, hoop + other.hoop};
  }
  bem::Vec2 on(bem::Vec2 normal) const {
    return {xx * normal.x + xy * normal.y, xy * normal.x + yy * normal.y};
  }
};

inline BodyStress operator*(double factor, const BodyStress& s) {
  return {factor * s.xx, factor * s.yy, factor * s.xy, factor * s.hoop};
}

}  // namespace epafi::contact
