#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// Further unknowns beside displacements and densities, and entries of the symmetric
/// system that are not those of boundary operators.  Both act between functions that
/// touch, and alone between bodies.
struct LocalCoupling {
  std::vector<int> elements;  ///< of each further unknown, one that it is on
  std::vector<int> bodies;    ///< and whose that is; empty: all are the first body's
  /// Of each body: what all of them do to its exact rotation less the interpolated one, where
  /// it has arcs, see Rotation; empty: nothing.
  std::vector<Vector> rotations;
  /// Unknowns are numbered body by body as unknownsOf has them, further ones behind all.  One
  /// of (i, j) and (j, i).
  struct Entry {
    Index row;
    Index column;
    double value;
  };
  std::vector<Entry> entries;
};

}  // namespace epafi::bem
