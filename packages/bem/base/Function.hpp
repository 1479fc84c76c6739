#pragma once

#include "bem/base/Vec2.hpp"

#include <functional>

namespace epafi::bem {

/// A scalar function of a point of the boundary, in the user's units: gap, load, friction
/// bound.  Empty: not given.
using Function = std::function<double(Vec2)>;

}  // namespace epafi::bem
