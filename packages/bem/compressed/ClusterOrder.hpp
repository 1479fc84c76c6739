#pragma once

#include "bem/compressed/ClusterTree.hpp"

#include <vector>

namespace epafi::bem {

struct BodyElement {
  int body;
  int element;
};

/// A coupling entry between a multiplier on the carrier and an element opposite to it; size:
/// its absolute value.
struct Link {
  BodyElement carrier;
  BodyElement opposite;
  double size;
};

/// Order of the elements of all bodies in which elements that face each other are neighbours:
/// consecutive carriers form a stretch, with their opposite elements sorted in by position;
/// all others keep the order of their meshes.  A cut of this order separates few links.
std::vector<ClusterPlace> clusterOrder(const std::vector<const Space*>& spaces,
                                       const std::vector<Link>& links);

}  // namespace epafi::bem
