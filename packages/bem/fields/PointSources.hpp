#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/LegendreMoments.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <vector>

namespace epafi::bem {

/// The kernels' building blocks with a complex density g, w = x - y:
///
///   overW = ∫ g ds/w,  overConj = ∫ g ds/conj(w),  cubic = ∫ conj(g) w/conj(w)² ds
struct SourceSums {
  Complex overW;
  Complex overConj;
  Complex cubic;

  void add(const SourceSums& other) {
    overW += other.overW;
    overConj += other.overConj;
    cubic += other.cubic;
  }
};

/// Sums of a density ψ and of a displacement's derivative u'.
struct FieldSums {
  SourceSums density;
  SourceSums slope;

  void add(const FieldSums& other) {
    density.add(other.density);
    slope.add(other.slope);
  }
};

/// K' ψ + W u on a line with unit normal N.                      [design.md 4.3, last
/// item]
Complex traction(const Lame& lame, Complex normal, const FieldSums& sums);

/// d/ds (V ψ - K u) along the unit tangent τ = iN:
///
///   d/ds V f = ∫ -A Re(τ/w) f + B/2 conj(f) (τ/conj(w) - conj(τ) w/conj(w)²) ds,
///
/// d/ds K u as in design.md 4.3, by parts for a closed boundary.
Complex mismatchSlope(const Lame& lame, Complex normal, const FieldSums& sums);

/// Many points that carry a density and a derivative each, weights included: what far
/// elements look like through Gauss points.  Structure of arrays.
class PointSources {
 public:
  void clear();
  void add(Complex place, Complex density, Complex slope);
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
