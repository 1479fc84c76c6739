#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/simd/ComplexPack.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <vector>

namespace epafi::bem {

/// Many points that carry a density and a derivative of each of some states, weights included:
/// what far elements look like through Gauss points.  Structure of arrays.
class PointSources {
 public:
  explicit PointSources(std::size_t states) : arrays_(2 + 4 * states) {}

  std::size_t size() const { return arrays_.front().size(); }

  /// A point more.
  void add(Complex place);
  /// What the first point that does not yet carry anything in a state does.
  void carry(std::size_t state, Complex density, Complex slope);
  /// The next points carry in all states what points first ... last - 1 of others do.
  void carry(const PointSources& others, std::size_t first, std::size_t last);

  /// Sums of a state in eight lanes: Re g a, Im g b, Im g a, Re g b for 1/w = a - ib, and the cubic
  /// part; of the density and of the slope.
  struct Sums {
    AlignedLane of[2][6] = {};
    FieldSums at(std::size_t lane) const;
    FieldSums total() const;
  };
  /// Adds the products of a density and of kernels 1/conj(w) and w/conj(w)².
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

  /// Adds those of the points first ... last - 1 at x for each state, in about 1 ns a point.
  void addAt(Complex x, std::size_t first, std::size_t last, std::vector<Sums>& sums,
             InstructionSet set = largestInstructionSet()) const;

 private:
  /// x, y, and of each state x and y of the density and of the slope.
  std::vector<Vector> arrays_;
};

}  // namespace epafi::bem
