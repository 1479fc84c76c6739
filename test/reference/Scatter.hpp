#pragma once

#include "bem/operators/Assembly.hpp"
#include "reference/LaneMoments.hpp"

#include <array>

namespace epafi::reference {

/// Turns the moments of a pair (e, f), f <= e, into entries of V, K + 1/2 and W and adds
/// them entry by entry.
class Scatter {
 public:
  Scatter(const bem::Space& space, const bem::Lame& lame, bem::Operators& out);

  void add(int e, int f, const LaneMoments& moments) const;

 private:
  /// A symmetric block of the kernels: xx, xy and yy.
  struct Kernel {
    double xx;
    double xy;
    double yy;
  };

  template <class Moments>
  void addDoubleLayer(int test, int source, const Moments& moments) const;
  void addTurning(int e, int f, double phaseReal, double phaseImag) const;
  void addTurningAtEnds(int test, int source, const Kernel& turning) const;
  void addHypersingular(int e, int i, int f, int j, const Kernel& v) const;
  void addHalfMass(int e) const;

  const bem::Space& space_;
  bem::Lame lame_;
  std::array<double, bem::largestDegree + 1> slopes_{};
  bem::Operators& out_;
};

}  // namespace epafi::reference
