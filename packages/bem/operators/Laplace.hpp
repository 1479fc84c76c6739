#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

// A harmonic function on the boundary is one vector: its flows q = ∂T/∂n, Legendre series on the
// elements, then T by nodes and bubbles; each numbered as one component of a Space.
inline Index flowOf(const Space& space, int e, int i) {
  return space.density(e, i, 0) / 2;
}
inline Index potentialOf(const Space& space, int e, int k) {
  return (space.densities() + space.displacement(e, k, 0)) / 2;
}

/// Laplace's equation inside with T given on some elements and q on the others.  With w = x - y
///
///   V q = -1/2π ∫ log|w| q ds,  K T = 1/2π ∫ (w·n_y)/|w|² T ds,  W T = -d/ds V (dT/ds),
///   V q = (1/2 + K) T,          W T = (1/2 - K') q,
///
/// the first one is tested where T is given, the second where q is.  A constant on a hole's loop on
/// which q alone is given does nothing elsewhere: the first one's mean over it tells.  Dense.
/// Dimensionless, the outline's diameter at most 1.      [doc/theory/operators.md]
class MixedLaplace {
 public:
  /// The space has as many densities as its degree on each element; by element: is T given there?
  /// \pre somewhere.
  MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven);

  /// What is given, completed: of `data` what is not is ignored.
  Vector solve(Vector data) const;

  /// [V, -(K + 1/2); K' - 1/2, W], the last plus what holds constants on such loops.
  const Matrix& operators() const { return all_; }

 private:
  /// Its constant densities, and the nodes of its constant.
  struct FreeLoop {
    std::vector<Index> flows;
    std::vector<Index> nodes;
    double length = 0;
  };
  void assemble(const Space& space);
  void holdConstants(const Space& space, const std::vector<bool>& isPotentialGiven);

  Matrix all_;
  std::vector<Index> unknown_;
  LuFactor factor_;
  std::vector<FreeLoop> freeLoops_;
};

}  // namespace epafi::bem
