#pragma once

#include "bem/compressed/ClusterTree.hpp"

#include <vector>

namespace epafi::bem {

struct BodyElement {
  int body;
  int element;
};

/// Something that acts on elements of two bodies; it is numbered with the first.
struct Link {
  BodyElement carrier;
  BodyElement met;
  double size;
};

/// All elements of all bodies, so that those that face each other stand side by side:
/// consecutive elements that carry links are one stretch, with every element that they meet
/// at its place along them; others follow each other as in their meshes.  What is cut
/// anywhere then separates few links.
std::vector<ClusterPlace> facingOrder(const std::vector<const Space*>& spaces,
                                      const std::vector<Link>& links);

}  // namespace epafi::bem
