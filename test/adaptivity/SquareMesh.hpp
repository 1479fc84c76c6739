#pragma once

#include "bem/mesh/Mesh.hpp"

namespace epafi::test {

/// The unit square, side "bottom" first, with one to four elements on its sides.
inline bem::Mesh squareMesh(int degree) {
  const bem::Loop square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                         {"bottom", "right", "top", "left"}};
  return bem::makeMesh(std::make_shared<bem::Outline>(square), {3, 1, 2, 4}, degree);
}

}  // namespace epafi::test
