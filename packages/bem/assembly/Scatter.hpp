#pragma once

#include "bem/assembly/Assembly.hpp"
#include "bem/assembly/PairMoments.hpp"

#include <array>

namespace epafi::bem {

/// Turns moments into entries of V, K + 1/2 and W and adds them to the rows that are
/// mine. Calls with pairs whose second elements share no node with each other's first may
/// run at the same time.
class Scatter {
 public:
  Scatter(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
          Operators& out);

  void add(int e, int f, const PairMoments& moments) const;

 private:
  /// A symmetric block of the kernels: xx, xy and yy.
  struct Kernel {
    double xx;
    double xy;
    double yy;
  };

  template <class Moments>
  void addDoubleLayer(int test, int source, const Moments& moments) const;
  void addTurningAtEdgeEnds(int e, int f, const Kernel& turning) const;
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
