#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/simd/ComplexPack.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <vector>

namespace epafi::bem {

/// Point sources that replace far elements: Gauss points with ψ and u' of each state, times the
/// quadrature weight.  Structure of arrays.
class PointSources {
 public:
  explicit PointSources(std::size_t states)
      : arrays_(0, 2 + 4 * static_cast<Index>(states)) {}

  std::size_t size() const { return size_; }

  /// Appends a point.
  void add(Complex place);
  /// Sets the values of a state at the last point.
  void carry(std::size_t state, Complex density, Complex slope);
  /// Copies the values of the points first ... last - 1 of `others` to the last points.
  void carry(const PointSources& others, std::size_t first, std::size_t last);

  /// Partial sums of a state in eight lanes: Re g a, Im g b, Im g a, Re g b for 1/w = a - ib, and
  /// the real and imaginary cubic part; for g = density and g = slope.
  struct Sums {
    AlignedLane of[2][6] = {};
    FieldSums at(std::size_t lane) const;
    FieldSums total() const;
  };
  /// Adds the products of a density with the kernels 1/conj(w) and w/conj(w)².
  template <class Density>
  static EPAFI_INLINE void addProducts(const Density& density,
                                       const ComplexPack& overConj,
                                       const ComplexPack& cubic, Pack (&to)[6]) {
    const auto x = real(density);
    const auto y = imag(density);
    to[0] += x * overConj.re;
    to[1] += y * overConj.im;
    to[2] += y * overConj.re;
    to[3] += x * overConj.im;
    to[4] += cubic.re * x + cubic.im * y;
    to[5] += cubic.im * x - cubic.re * y;
  }

  /// Adds the sums over the points first ... last - 1 at the target x for each state.
  void addAt(Complex x, std::size_t first, std::size_t last, std::vector<Sums>& sums,
             InstructionSet set = largestInstructionSet()) const;

 private:
  /// Columns: point x, y; then for each state density x, y and slope x, y.  One allocation, with room
  /// for more points.
  Matrix arrays_;
  std::size_t size_ = 0;
};

}  // namespace epafi::bem
