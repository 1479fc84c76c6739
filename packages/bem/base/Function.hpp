#pragma once

#include "bem/base/Vec2.hpp"

#include <functional>

namespace epafi::bem {

/// A number at each point of the boundary, in the user's units: gap, load, friction
/// bound. An empty function means "not given".
using Function = std::function<double(Vec2)>;

}  // namespace epafi::bem
