#pragma once

#include "bem/mesh/Mesh.hpp"

#include <memory>

namespace epafi::test {

inline std::shared_ptr<const bem::Outline> outlineOf(const bem::Loop& loop) {
  return std::make_shared<const bem::Outline>(loop);
}

/// From a corner on; its sides are "bottom", "right", "top", "left".
inline bem::Loop rectangle(bem::Vec2 from, double width, double height) {
  const bem::Vec2 to{from.x + width, from.y + height};
  return {{from, {to.x, from.y}, to, {from.x, to.y}}, {"bottom", "right", "top", "left"}};
}

/// The unit square.
inline bem::Mesh squareMesh(const std::vector<int>& elements, int degree) {
  return bem::makeMesh(outlineOf(rectangle({0, 0}, 1, 1)), elements, degree);
}

/// With one to four elements on its sides.
inline bem::Mesh squareMesh(int degree) { return squareMesh({3, 1, 2, 4}, degree); }

}  // namespace epafi::test
