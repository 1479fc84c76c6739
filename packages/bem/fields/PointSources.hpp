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
  /// Points first ... first + count - 1 of others at other places: place(q), q < count.
  template <class Place>
  void add(const PointSources& others, std::size_t first, std::size_t count,
           const Place& place) {
    const std::size_t old = size();
    for (int array = 0; array < Arrays; ++array) {
      const double* from = others.data_[array].data() + first;
      data_[array].insert(data_[array].end(), from, from + count);
    }
    for (std::size_t q = 0; q < count; ++q) {
      const Complex x = place(q);
      data_[X][old + q] = x.real();
      data_[Y][old + q] = x.imag();
    }
  }
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
