#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <vector>

namespace epafi::bem {

/// Many points that carry a density and a derivative each, weights included: what far
/// elements look like through Gauss points.  Structure of arrays.
class PointSources {
 public:
  void add(Complex place, Complex density, Complex slope);
  /// A point of others at another place.
  void add(Complex place, const PointSources& others, std::size_t k);
  std::size_t size() const { return data_[X].size(); }

  /// Their sums at x, in about 1 ns a point.
  FieldSums at(Complex x, InstructionSet set = largestInstructionSet()) const {
    return at(x, 0, size(), set);
  }
  /// Of the points first ... last - 1 only.
  FieldSums at(Complex x, std::size_t first, std::size_t last,
               InstructionSet set = largestInstructionSet()) const;

 private:
  enum { X, Y, DensityX, DensityY, SlopeX, SlopeY, Arrays };
  std::vector<double> data_[Arrays];
};

}  // namespace epafi::bem
