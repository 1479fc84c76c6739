#include "bem/fields/KernelRows.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <array>

namespace epafi::bem {

namespace {

/// 1/conj(w) and w/conj(w)² at eight targets.
struct Kernels {
  Pack overConj[2];
  Pack cubic[2];

  template <Division How>
  EPAFI_INLINE void evaluate(const Pack& wx, const Pack& wy) {
    Pack inverse;
    reciprocal<How>(wx * wx + wy * wy, inverse);
    const ComplexPack first{wx * inverse, wy * inverse};
    const ComplexPack second = ComplexPack{wx, wy} * first * first;
    overConj[0] = first.re;
    overConj[1] = first.im;
    cubic[0] = second.re;
    cubic[1] = second.im;
  }
};

/// The four numbers of a pack of targets in a column.
EPAFI_INLINE void storeAt(std::size_t pack, std::size_t packs, double* column,
                          const Pack (&numbers)[4]) {
  for (std::size_t part = 0; part < 4; ++part)
    store(column + (part * packs + pack) * lanes, numbers[part]);
}

struct FarColumns {
  const std::vector<ComplexLanes>& targets;
  const Vec2* places;  ///< of Gauss points, from the midpoint
  std::size_t count;
  Vec2 way;
  const WeightedLegendre& legendre;
  double half;
  MatrixView to;

  template <Division How>
  EPAFI_INLINE void run() const {
    Kernels kernels[largestGaussOrder];  // NOLINT(cppcoreguidelines-pro-type-member-init)
    for (std::size_t pack = 0; pack < targets.size(); ++pack) {
      const ComplexPack target = targets[pack].load();
      for (std::size_t q = 0; q < count; ++q) {
        const Vec2 place = places[q] - way;
        kernels[q].template evaluate<How>(target.re - place.x, target.im - place.y);
      }
      for (Index k = 0; k < to.columns(); ++k) {
        Pack sums[4] = {};
        for (std::size_t q = 0; q < count; ++q) {
          const double weight = legendre[q][static_cast<std::size_t>(k)];
          for (std::size_t part = 0; part < 2; ++part) {
            sums[part] += weight * kernels[q].overConj[part];
            sums[2 + part] += weight * kernels[q].cubic[part];
          }
        }
        for (Pack& sum : sums)
          sum *= half;
        storeAt(pack, targets.size(), to.column(k), sums);
      }
    }
  }
};

struct NearColumns {
  const ElementPotential& kernels;
  std::size_t pack;
  std::size_t packs;
  MatrixView to;

  template <Division>
  EPAFI_INLINE void run() const {
    for (Index k = 0; k < to.columns(); ++k) {
      const ElementPotential::Values of = kernels.of(asInt(k));
      storeAt(pack, packs, to.column(k),
              {of.overConj.re, of.overConj.im, of.cubic.re, of.cubic.im});
    }
  }
};

/// From the sums of a state to both equations.
struct Equations {
  const Lame& lame;
  const std::vector<ComplexLanes>& normals;
  ConstMatrixView sums;  ///< four columns
  MatrixView to;         ///< likewise

  /// From products of a density x + iy with 1/conj(w) = a + ib and w/conj(w)² = c + id.
  EPAFI_INLINE SumsOf<ComplexPack> of(Index x, std::size_t pack) const {
    const auto number = [&](std::size_t part, Index component) -> const Pack& {
      return load(sums.column(component) + (part * normals.size() + pack) * lanes);
    };
    const Index y = x + 1;
    return {{number(0, x) + number(1, y), number(0, y) - number(1, x)},
            {number(0, x) - number(1, y), number(0, y) + number(1, x)},
            {number(2, x) + number(3, y), number(3, x) - number(2, y)}};
  }

  template <Division>
  EPAFI_INLINE void run() const {
    for (std::size_t pack = 0; pack < normals.size(); ++pack) {
      const ComplexPack normal = normals[pack].load();
      const FieldSumsOf<ComplexPack> fields{of(0, pack), of(2, pack)};
      const ComplexPack force = traction(lame, normal, fields);
      const ComplexPack slope = mismatchSlope(lame, normal, fields);
      const std::size_t row = pack * lanes;
      store(to.column(0) + row, force.re);
      store(to.column(1) + row, force.im);
      store(to.column(2) + row, slope.re);
      store(to.column(3) + row, slope.im);
    }
  }
};

constexpr Index blockSize = 1 << 15;  // numbers, which a cache holds

}  // namespace

KernelRows::KernelRows(const FieldSources& sources, std::size_t targets)
    : sources_(sources),
      packs_(static_cast<Index>((targets + lanes - 1) / lanes)),
      integrals_(Matrix::unset(
          4 * packs_ * lanes,
          std::max<Index>(largestMoment + 1, blockSize / (4 * packs_ * lanes)))),
      sums_(4 * packs_ * lanes, sources.coefficients.columns()) {}

MatrixView KernelRows::columnsOf(int source) {
  const Stretch rows{sources_.firsts[at(source)], sources_.firsts[at(source) + 1]};
  const Index count = rows.last - rows.first;
  if (taken_ + count > integrals_.columns())
    multiply();
  if (!stretches_.empty() && stretches_.back().last == rows.first)
    stretches_.back().last = rows.last;
  else
    stretches_.push_back(rows);
  taken_ += count;
  return MatrixView(integrals_).columnsBetween(taken_ - count, taken_);
}

void KernelRows::multiply() {
  const ConstMatrixView all = sources_.coefficients;
  const ConstMatrixView columns = MatrixView(integrals_).columnsBetween(0, taken_);
  if (stretches_.size() == 1) {
    addProduct(1, columns, all.rowsBetween(stretches_[0].first, stretches_[0].last),
               sums_);
  } else if (taken_ > 0) {
    Matrix chosen = Matrix::unset(taken_, all.columns());
    for (Index j = 0; j < all.columns(); ++j) {
      double* to = chosen.column(j);
      for (const Stretch& rows : stretches_)
        to = std::copy(all.column(j) + rows.first, all.column(j) + rows.last, to);
    }
    addProduct(1, columns, chosen, sums_);
  }
  taken_ = 0;
  stretches_.clear();
}

void KernelRows::add(const FarSource& source, const std::vector<ComplexLanes>& targets) {
  const Element& element = sources_.mesh[source.element];
  const auto order = at(source.order);
  std::vector<Vec2> own;
  const Vec2* places = nullptr;
  if (order < sources_.places.size()) {
    places = sources_.places[order].data() + at(source.element) * order;
  } else {
    for (const double t : gaussLegendre(source.order).points)
      own.push_back(element.curve.fromMiddle(t));
    places = own.data();
  }
  dispatch(FarColumns{targets, places, order, source.way, weightedLegendre(source.order),
                      element.half, columnsOf(source.element)});
}

void KernelRows::add(int source, const std::vector<TargetLanes>& targets) {
  const MatrixView to = columnsOf(source);
  ElementPotential kernels(sources_.mesh[source].curve, asInt(to.columns()));
  for (std::size_t pack = 0; pack < targets.size(); ++pack) {
    kernels.evaluate(targets[pack]);
    dispatch(NearColumns{kernels, pack, targets.size(), to});
  }
}

Matrix KernelRows::equations(const Lame& lame, const std::vector<ComplexLanes>& normals) {
  multiply();
  Matrix result = Matrix::unset(packs_ * lanes, sums_.columns());
  for (Index j = 0; j < sums_.columns(); j += 4)
    dispatch(Equations{lame, normals, ConstMatrixView(sums_).columnsBetween(j, j + 4),
                       MatrixView(result).columnsBetween(j, j + 4)});
  return result;
}

}  // namespace epafi::bem
