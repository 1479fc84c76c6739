#pragma once

#include "bem/compressed/ClusterTree.hpp"

#include <vector>

namespace epafi::bem {

struct BodyElement {
  int body;
  int element;
};

/// A coupling between elements of two bodies, such as a multiplier on the carrier.
struct Link {
  BodyElement carrier;
  BodyElement met;
  double size;
};

/// Order of the elements of all bodies in which elements that face each other are neighbours:
/// consecutive elements that carry links form a stretch, with the elements that they meet
/// sorted in by position; all others keep the order of their meshes.  A cut of this order
/// separates few links.
std::vector<ClusterPlace> facingOrder(const std::vector<const Space*>& spaces,
                                      const std::vector<Link>& links);

}  // namespace epafi::bem
