#include "bem/fields/PointSources.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <utility>

namespace epafi::bem {

namespace {

/// At eight points.
struct Kernels {
  ComplexPack overConj;  ///< 1/conj(w)
  ComplexPack cubic;     ///< w/conj(w)²
};

EPAFI_INLINE void load(const double* from, Pack& to) {
  __builtin_memcpy(&to, from, sizeof to);
}

template <Division How>
EPAFI_INLINE void evaluate(const Pack& wx, const Pack& wy, Kernels& k) {
  Pack inverse;
  reciprocal<How>(wx * wx + wy * wy, inverse);
  k.overConj = {wx * inverse, wy * inverse};
  k.cubic = ComplexPack{wx, wy} * k.overConj * k.overConj;
}

struct Summation {
  const Matrix& arrays;
  std::size_t first;
  std::size_t last;
  double x;
  double y;
  std::vector<PointSources::Sums>& sums;

  // the last points among some that carry nothing, away from x
  EPAFI_INLINE void read(std::size_t array, std::size_t k, double other, Pack& to) const {
    const double* from = arrays.column(static_cast<Index>(array)) + k;
    if (k + lanes <= last)
      return load(from, to);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      to[lane] = k + lane < last ? from[lane] : other;
  }

  template <Division How>
  EPAFI_INLINE void kernelsAt(std::size_t k, Kernels& kernels) const {
    Pack px;
    Pack py;
    read(0, k, x + 1, px);
    read(1, k, y, py);
    evaluate<How>(x - px, y - py, kernels);
  }

  EPAFI_INLINE void add(std::size_t state, std::size_t k, const Kernels& by,
                        Pack (&to)[2][6]) const {
    for (std::size_t field = 0; field < 2; ++field) {
      ComplexPack density;
      read(2 + 4 * state + 2 * field, k, 0, density.re);
      read(3 + 4 * state + 2 * field, k, 0, density.im);
      PointSources::addProducts(density, by.overConj, by.cubic, to[field]);
    }
  }

  // kernels of some points at a time, which every state takes
  template <Division How>
  EPAFI_INLINE void run() const {
    constexpr std::size_t atOnce = 64;
    Kernels kernels[atOnce / lanes];
    for (std::size_t from = first; from < last; from += atOnce) {
      const std::size_t to = std::min(from + atOnce, last);
      for (std::size_t k = from; k < to; k += lanes)
        kernelsAt<How>(k, kernels[(k - from) / lanes]);
      for (std::size_t state = 0; state < sums.size(); ++state) {
        Pack own[2][6] = {};
        for (std::size_t k = from; k < to; k += lanes)
          add(state, k, kernels[(k - from) / lanes], own);
        for (std::size_t field = 0; field < 2; ++field)
          for (std::size_t part = 0; part < 6; ++part)
            bem::add(sums[state].of[field][part].lane, own[field][part]);
      }
    }
  }
};

}  // namespace

void PointSources::add(Complex place) {
  const auto size = static_cast<Index>(size_);
  if (size == arrays_.rows()) {
    constexpr Index least = 128;
    Matrix larger = Matrix::unset(std::max(least, 2 * size), arrays_.columns());
    for (Index j = 0; j < arrays_.columns(); ++j)
      std::copy_n(arrays_.column(j), size, larger.column(j));
    arrays_ = std::move(larger);
  }
  arrays_(size, 0) = place.real();
  arrays_(size, 1) = place.imag();
  ++size_;
}

void PointSources::carry(std::size_t state, Complex density, Complex slope) {
  Index array = 2 + 4 * static_cast<Index>(state);
  for (const double number : {density.real(), density.imag(), slope.real(), slope.imag()})
    arrays_(static_cast<Index>(size_) - 1, array++) = number;
}

void PointSources::carry(const PointSources& others, std::size_t first,
                         std::size_t last) {
  for (Index array = 2; array < arrays_.columns(); ++array)
    std::copy(others.arrays_.column(array) + first, others.arrays_.column(array) + last,
              arrays_.column(array) + (size_ - (last - first)));
}

void PointSources::addAt(Complex x, std::size_t first, std::size_t last,
                         std::vector<Sums>& sums, InstructionSet set) const {
  dispatch(set, Summation{arrays_, first, last, x.real(), x.imag(), sums});
}

FieldSums PointSources::Sums::at(std::size_t lane) const {
  const auto sums = [lane](const AlignedLane(&parts)[6]) {
    const auto s = [&](int part) { return parts[part].lane[lane]; };
    return SourceSums{
        {s(0) + s(1), s(2) - s(3)}, {s(0) - s(1), s(2) + s(3)}, {s(4), s(5)}};
  };
  return {sums(of[0]), sums(of[1])};
}

FieldSums PointSources::Sums::total() const {
  FieldSums sum;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    sum.add(at(lane));
  return sum;
}

}  // namespace epafi::bem
