#pragma once

#include "bem/moments/PairMoments.hpp"
#include "bem/operators/Assembly.hpp"

#include <array>

namespace epafi::bem {

/// Turns the moments of a pair (e, f), f <= e, into entries of V, K + 1/2 and W and adds
/// them to the rows that are mine: what is not far, or closes a loop; for all others see
/// FarScatter.  Calls whose f share no node may run at the same time, unless an e closes
/// its loop.
class Scatter {
 public:
  Scatter(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
          Operators& out);

  void add(int e, int f, const PairMoments& moments) const;

  /// What a pair on one edge gives to the ends of it beside what FarBlocks has, w/conj(w)
  /// integrated over both.
  void addTurning(int e, int f, double phaseReal, double phaseImag) const;

 private:
  /// A symmetric block of the kernels: xx, xy and yy.
  struct Kernel {
    double xx;
    double xy;
    double yy;
  };

  template <class Moments>
  void addDoubleLayer(int test, int source, const Moments& moments) const;
  void addTurningAtEnds(int test, int source, const Kernel& turning) const;
  void addHypersingular(int e, int i, int f, int j, const Kernel& v) const;
  void addHalfMass(int e) const;

  const Space& space_;
  Lame lame_;
  Rows densityRows_;
  Rows displacementRows_;
  std::array<double, largestDegree + 1> slopes_{};
  Operators& out_;
};

}  // namespace epafi::bem
