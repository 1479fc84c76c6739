#pragma once

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/space/Space.hpp"

#include <optional>
#include <vector>

namespace epafi::bem {

/// A harmonic function on the boundary: T by nodes and bubbles, and its flow q = ∂T/∂n as
/// Legendre series on the elements.  Numbered as one component of a Space.
struct HarmonicData {
  Vector potential;
  Vector flow;

  static Index potentialOf(const Space& space, int e, int k) {
    return space.displacement(e, k, 0) / 2;
  }
  static Index flowOf(const Space& space, int e, int i) {
    return space.density(e, i, 0) / 2;
  }
};

/// Laplace's equation inside with T given on some elements and q on the others.  With w = x - y
///
///   V q = -1/2π ∫ log|w| q ds,  K T = 1/2π ∫ (w·n_y)/|w|² T ds,  W T = -d/ds V (dT/ds),
///   V q = (1/2 + K) T,          W T = (1/2 - K') q,
///
/// the first one is tested where T is given, the second where q is.  A constant on a hole's loop on
/// which q alone is given does nothing elsewhere: the first one's mean over it tells.  Dense: N² numbers twice, N
/// flows.  Dimensionless, the outline's diameter at most 1.      [doc/theory/operators.md]
class MixedLaplace {
 public:
  /// Refers to the space, which has as many densities as its degree on each element; by element:
  /// is T given there?  \pre somewhere.
  MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven);

  /// What is given, completed: of `given` what is not is ignored.
  HarmonicData solve(const HarmonicData& given) const;

  const Matrix& singleLayer() const { return single_; }  ///< V
  const Matrix& doubleLayer() const { return double_; }  ///< K + 1/2

 private:
  /// A hole's loop without a given T: its constant densities, and the nodes of its constant.
  struct FreeLoop {
    std::vector<Index> flows;
    std::vector<Index> nodes;
    double length = 0;
  };
  void assemble();
  void findFreeLoops(const std::vector<bool>& isPotentialGiven);
  Vector meanOf(const FreeLoop& loop) const;
  Vector slopeOf(const Vector& potential) const;
  Vector transposedSlopeOf(const Vector& flow) const;

  const Space& space_;
  Matrix single_;
  Matrix double_;
  std::vector<Entry> half_;    ///< <φ, P>/2
  std::vector<Entry> slopes_;  ///< dφ/ds by P
  std::vector<Index> unknownPotentials_;
  std::vector<Index> unknownFlows_;
  std::vector<FreeLoop> freeLoops_;
  std::optional<CholeskyFactor> flows_;  ///< V of unknown flows, L Lᵀ
  Matrix response_;  ///< Y = L⁻¹ (K + 1/2) of the unknown potentials
  std::optional<CholeskyFactor> potentials_;  ///< W + Yᵀ Y
};

}  // namespace epafi::bem
