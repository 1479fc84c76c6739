#include "bem/fields/PointSources.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>

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
  const double* data;
  std::size_t capacity;
  std::size_t first;
  std::size_t last;
  double x;
  double y;
  std::vector<PointSources::Sums>& sums;

  // the last points among some that carry nothing, away from x
  EPAFI_INLINE void read(std::size_t array, std::size_t k, double other, Pack& to) const {
    const double* from = data + array * capacity + k;
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

  EPAFI_INLINE void keep(std::size_t state, const Pack (&from)[2][6]) const {
    for (std::size_t field = 0; field < 2; ++field)
      for (std::size_t part = 0; part < 6; ++part)
        bem::add(sums[state].of[field][part].lane, from[field][part]);
  }

  // kernels of some points at a time, which every state takes
  template <Division How>
  EPAFI_INLINE void run() const {
    if (sums.size() == 1)
      return runAlone<How>();
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
        keep(state, own);
      }
    }
  }

  template <Division How>
  EPAFI_INLINE void runAlone() const {
    Pack own[2][6] = {};
    for (std::size_t k = first; k < last; k += lanes) {
      Kernels kernels;
      kernelsAt<How>(k, kernels);
      add(0, k, kernels, own);
    }
    keep(0, own);
  }
};

}  // namespace

void PointSources::reserve(std::size_t more) {
  if (size_ + more <= capacity_)
    return;
  const std::size_t capacity = std::max(2 * capacity_, size_ + more);
  std::unique_ptr<double[]> data(new double[arrays_ * capacity]);
  for (std::size_t array = 0; array < arrays_; ++array)
    std::copy_n(data_.get() + array * capacity_, size_, data.get() + array * capacity);
  data_ = std::move(data);
  capacity_ = capacity;
}

void PointSources::carry(std::size_t point, std::size_t state, Complex density,
                         Complex slope) {
  const double numbers[] = {density.real(), density.imag(), slope.real(), slope.imag()};
  for (std::size_t k = 0; k < 4; ++k)
    data_[(2 + 4 * state + k) * capacity_ + point] = numbers[k];
}

void PointSources::carry(std::size_t point, const PointSources& others, std::size_t first,
                         std::size_t last) {
  for (std::size_t array = 2; array < arrays_; ++array) {
    const double* from = others.data_.get() + array * others.capacity_;
    double* to = data_.get() + array * capacity_ + point;
    for (std::size_t k = first; k < last; ++k)
      *to++ = from[k];
  }
}

void PointSources::addAt(Complex x, std::size_t first, std::size_t last,
                         std::vector<Sums>& sums, InstructionSet set) const {
  dispatch(set, Summation{data_.get(), capacity_, first, last, x.real(), x.imag(), sums});
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
