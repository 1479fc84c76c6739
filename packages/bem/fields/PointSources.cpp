#include "bem/fields/PointSources.hpp"

#include "bem/simd/Dispatch.hpp"

namespace epafi::bem {

namespace {

struct Columns {
  const double* array[6];
  std::size_t size;
};

/// Sums over lanes:  Re g a, Im g b, Im g a, Re g b, and cubic's parts.
struct LaneSums {
  Pack sum[6] = {};
};

EPAFI_INLINE void load(const double* from, Pack& to) {
  __builtin_memcpy(&to, from, sizeof to);
}

/// 1/w = a - ib,  1/conj(w) = a + ib,  w/conj(w)² = gx + i gy.
template <Division How>
EPAFI_INLINE void addEight(const Columns& c, std::size_t k, double x, double y,
                           LaneSums (&fields)[2]) {
  Pack px;
  Pack py;
  load(c.array[0] + k, px);
  load(c.array[1] + k, py);
  const Pack wx = x - px;
  const Pack wy = y - py;
  Pack inverse;
  reciprocal<How>(wx * wx + wy * wy, inverse);
  const Pack a = wx * inverse;
  const Pack b = wy * inverse;
  const Pack ex = a * wx - b * wy;
  const Pack ey = a * wy + b * wx;
  const Pack gx = ex * a - ey * b;
  const Pack gy = ex * b + ey * a;
  for (int field = 0; field < 2; ++field) {
    Pack fx;
    Pack fy;
    load(c.array[2 + 2 * field] + k, fx);
    load(c.array[3 + 2 * field] + k, fy);
    Pack(&s)[6] = fields[field].sum;
    s[0] += fx * a;
    s[1] += fy * b;
    s[2] += fy * a;
    s[3] += fx * b;
    s[4] += gx * fx + gy * fy;
    s[5] += gy * fx - gx * fy;
  }
}

EPAFI_INLINE double total(const Pack& p) {
  double sum = 0;
  for (int lane = 0; lane < lanes; ++lane)
    sum += p[lane];
  return sum;
}

struct Summation {
  const Columns& c;
  double x;
  double y;
  double (&result)[2][6];

  template <Division How>
  EPAFI_INLINE void run() const {
    LaneSums fields[2];
    std::size_t k = 0;
    for (; k + lanes <= c.size; k += lanes)
      addEight<How>(c, k, x, y, fields);
    if (k < c.size) {  // the rest among points that carry nothing, away from x
      double rest[6][lanes] = {};
      for (int lane = 0; lane < lanes; ++lane)
        rest[0][lane] = x + 1;
      for (int array = 0; array < 6; ++array)
        for (std::size_t at = k; at < c.size; ++at)
          rest[array][at - k] = c.array[array][at];
      addEight<How>({{rest[0], rest[1], rest[2], rest[3], rest[4], rest[5]}, lanes}, 0, x,
                    y, fields);
    }
    for (int field = 0; field < 2; ++field)
      for (int part = 0; part < 6; ++part)
        result[field][part] = total(fields[field].sum[part]);
  }
};

/// ∫ g/w, ∫ g/conj(w) and the cubic part from the products' sums.
SourceSums sourceSums(const double (&s)[6]) {
  return {{s[0] + s[1], s[2] - s[3]}, {s[0] - s[1], s[2] + s[3]}, {s[4], s[5]}};
}

}  // namespace

void PointSources::add(Complex place, Complex density, Complex slope) {
  data_[X].push_back(place.real());
  data_[Y].push_back(place.imag());
  data_[DensityX].push_back(density.real());
  data_[DensityY].push_back(density.imag());
  data_[SlopeX].push_back(slope.real());
  data_[SlopeY].push_back(slope.imag());
}

FieldSums PointSources::at(Complex x, std::size_t first, std::size_t last,
                           InstructionSet set) const {
  Columns columns{{}, last - first};
  for (int array = 0; array < Arrays; ++array)
    columns.array[array] = data_[array].data() + first;
  double sums[2][6];
  dispatch(set, Summation{columns, x.real(), x.imag(), sums});
  return {sourceSums(sums[0]), sourceSums(sums[1])};
}

}  // namespace epafi::bem
