#pragma once

#include "bem/geometry/Outline.hpp"

#include <vector>

namespace epafi::drivers {

/// The closed lines of a body, all counter-clockwise as Outline wants them.
struct Loops {
  bem::Loop outer;
  std::vector<bem::Loop> holes;
};

}  // namespace epafi::drivers
