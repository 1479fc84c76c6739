#pragma once

#include "bem/base/Vec2.hpp"

#include <functional>

namespace epafi::bem {

/// A point of a boundary in the user's coordinates, and the outward unit normal there.
struct SurfacePoint {
  double x = 0;
  double y = 0;
  Vec2 normal{};

  /// Functions that do not need the normal take a Vec2.
  operator Vec2() const { return {x, y}; }  // NOLINT(google-explicit-constructor)
};

/// A scalar function of a point of the boundary, in the user's units: gap, load, friction
/// bound.  Empty: not given.
using Function = std::function<double(const SurfacePoint&)>;

}  // namespace epafi::bem
