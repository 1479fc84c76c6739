#pragma once

#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// The functions that are not zero on an element, in the order of its blocks: the
/// displacements φ_k e_c, then the densities P_i e_c, components next to each other.
struct LocalFunctions {
  int displacements;  ///< 2 (p + 1)
  int densities;

  explicit LocalFunctions(const Element& element)
      : displacements(2 * (element.degree + 1)), densities(2 * element.densities) {}
  int size() const { return displacements + densities; }
};

/// An unknown of the coupled system, and where its function lives.
///
/// Unknowns are numbered: displacements as Space has them, densities, then others.
struct Unknown {
  int element = 0;      ///< the one that numbers it
  int local = 0;        ///< its function there; -1: none, see LocalCoupling
  bool isNode = false;  ///< it is also φ₁ of the element before
};

/// All of a space.
inline std::vector<Unknown> unknownsOf(const Space& space) {
  std::vector<Unknown> all(space.displacements() + space.densities());
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    const LocalFunctions local(element);
    for (int c = 0; c < 2; ++c) {
      all[space.displacement(e, 0, c)] = {e, c, true};
      for (int k = 2; k <= element.degree; ++k)
        all[space.displacement(e, k, c)] = {e, 2 * k + c, false};
      for (int i = 0; i < element.densities; ++i)
        all[space.displacements() + space.density(e, i, c)] = {
            e, local.displacements + 2 * i + c, false};
    }
  }
  return all;
}

}  // namespace epafi::bem
