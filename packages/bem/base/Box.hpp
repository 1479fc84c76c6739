#pragma once

#include "bem/base/Vec2.hpp"

#include <algorithm>
#include <limits>

namespace epafi::bem {

/// The smallest box around points, with sides along x and y.
struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec2 high{-low.x, -low.y};

  void add(Vec2 point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  Vec2 middle() const { return 0.5 * (low + high); }
  Vec2 size() const { return high - low; }
};

}  // namespace epafi::bem
