#include "bem/moments/FarPairs.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Gauss rules of the pairs, Legendre polynomials at their points, and where moments go.
struct Work {
  const Element& e;
  const ElementLanes& far;
  Tile& m;
  int rows = e.densities;
  int columns = far.densities;
  const Rule& outer = gaussLegendre(far.smooth.outer + degreeShare(rows));
  const Rule& inner = gaussLegendre(far.smooth.inner + degreeShare(columns));
  const WeightedLegendre& outerTable = weightedLegendre(outer.size());
  const WeightedLegendre& innerTable = weightedLegendre(inner.size());
};

/// The inner integrals of segments at one outer point; Degree 0 for any.
template <int Degree>
struct SegmentSums {
  static constexpr int size = (Degree > 0 ? Degree : largestMoment) + 2;
  Pack i[size];  // ∫ P_k / r²
  Pack j[size];  // ∫ P_k η / r²,  η = w·τ_F
  Pack l[size];  // ∫ P_k log r
};

template <int Degree, Division How>
EPAFI_INLINE void segmentSums(const Work& work, const Pack& eta0, const Pack& off2,
                              const Pack& a, SegmentSums<Degree>& in) {
  const int p = Degree > 0 ? Degree : work.columns;
  for (int k = 0; k <= p + 1; ++k)
    in.i[k] = Pack{};
  for (int q = 0; q < work.inner.size(); ++q) {
    const double* weights = work.innerTable[q].data();
    const Pack eta = eta0 - a * work.inner.points[q];
    Pack inverse;
    reciprocal<How>(eta * eta + off2, inverse);
    for (int k = 0; k <= p + 1; ++k)
      in.i[k] += inverse * weights[k];
  }
  for (int k = 0; k <= p; ++k) {
    Pack t = in.i[k + 1] * ((k + 1.0) / (2 * k + 1));
    if (k > 0)
      t += in.i[k - 1] * (static_cast<double>(k) / (2 * k + 1));
    in.j[k] = eta0 * in.i[k] - a * t;
  }
  // ∫ log r dt = (log r(1) + log r(-1)) + a ∫ t η/r² dt, and by parts for the others
  const Pack right = eta0 - a;
  const Pack left = eta0 + a;
  const Pack product = (right * right + off2) * (left * left + off2);
  Pack ends;
  logarithm(product, ends);
  in.l[0] = 0.5 * ends + a * in.j[1];
  for (int k = 1; k < p; ++k)
    in.l[k] = a * (in.j[k + 1] - in.j[k - 1]) * (1.0 / (2 * k + 1));
  in.l[p] = Pack{};
}

/// Between segments, all of one degree; Degree 0: of any.
template <int Degree, Division How>
EPAFI_INLINE void segmentKernel(const Work& work) {
  const int rows = Degree > 0 ? Degree : work.rows;
  const int columns = Degree > 0 ? Degree : work.columns;
  work.m.clear(rows, columns);
  const ElementLanes& far = work.far;
  const Curve::Frame e = work.e.segment();
  const double halfE = work.e.half;
  const Pack tx = load(far.tx);
  const Pack ty = load(far.ty);
  const Pack a = load(far.half);
  const Pack tangentOnNormal = tx * e.normal.x + ty * e.normal.y;  // τ_F·n_E
  const Pack normalOnNormal = ty * e.normal.x - tx * e.normal.y;   // n_F·n_E
  SegmentSums<Degree> in;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (int q = 0; q < work.outer.size(); ++q) {
    const double s = halfE * work.outer.points[q];
    const Pack wx = load(far.wx) + s * e.tangent.x;
    const Pack wy = load(far.wy) + s * e.tangent.y;
    const Pack off = wx * ty - wy * tx;
    segmentSums<Degree, How>(work, wx * tx + wy * ty, off * off, a, in);
    const double* weight = work.outerTable[q].data();
#pragma GCC unroll 3
    for (int j = 0; j <= columns; ++j) {
      const Pack offI = off * in.i[j];
      work.m.addInner({in.l[j], off * in.j[j], off * offI, a * offI,
                       -halfE * (tangentOnNormal * in.j[j] + normalOnNormal * offI)},
                      rows, columns, j, weight);
    }
  }
}

/// With arcs among them.
class alignas(64) ArcKernel {
 public:
  EPAFI_INLINE explicit ArcKernel(const Work& work) : work_(work) {}

  template <Division How>
  EPAFI_INLINE void run() {
    work_.m.clear(work_.rows, work_.columns);
    for (int q = 0; q < work_.inner.size(); ++q)
      points_[q] = work_.far.at(Pack{} + work_.inner.points[q]);
    for (int q = 0; q < work_.outer.size(); ++q) {
      const double s = work_.outer.points[q];
      const Curve& e = work_.e.curve;
      integrate<How>(e.fromMiddle(s), work_.e.half * e.normal(s));
      for (int j = 0; j <= work_.columns; ++j)
        work_.m.addInner(sums_[j], work_.rows, work_.columns, j,
                         work_.outerTable[q].data());
    }
  }

 private:
  template <Division How>
  EPAFI_INLINE void integrate(const Vec2& offset, const Vec2& normal) {
    for (int j = 0; j <= work_.columns; ++j)
      sums_[j] = Tile::Inner{};
    const Pack tx = load(work_.far.tx);
    const Pack ty = load(work_.far.ty);
    const Pack half = load(work_.far.half);
    const Pack middleX = load(work_.far.wx) + offset.x;
    const Pack middleY = load(work_.far.wy) + offset.y;
    for (int q = 0; q < work_.inner.size(); ++q) {
      const ElementLanes::Points& y = points_[q];
      const double* weights = work_.innerTable[q].data();
      const Pack wx = middleX - y.place.re;
      const Pack wy = middleY - y.place.im;
      const Pack square = wx * wx + wy * wy;
      Pack inverse;
      Pack logarithmOfSquare;
      reciprocal<How>(square, inverse);
      logarithm(square, logarithmOfSquare);
      const Pack eta = wx * tx + wy * ty;
      const Pack off = (wx * ty - wy * tx) * inverse;
      const Pack log = 0.5 * logarithmOfSquare;
      const Pack along = off * eta;
      const Pack across = off * (wx * ty - wy * tx);
      const Pack direct = half * (wx * y.tangent.im - wy * y.tangent.re) * inverse;
      const Pack reverse = -(wx * normal.x + wy * normal.y) * inverse;
      for (int j = 0; j <= work_.columns; ++j) {
        sums_[j].log += log * weights[j];
        sums_[j].along += along * weights[j];
        sums_[j].across += across * weights[j];
        sums_[j].direct += direct * weights[j];
        sums_[j].reverse += reverse * weights[j];
      }
    }
  }

  const Work& work_;
  ElementLanes::Points points_[largestGaussOrder];
  Tile::Inner sums_[largestMoment + 1];
};

struct FarKernel {
  const Work& work;

  template <Division How>
  EPAFI_INLINE void run() const {
    const bool hasArcs = work.e.curve.angle() != 0 ||
                         std::any_of(std::begin(work.far.alpha), std::end(work.far.alpha),
                                     [](double alpha) { return alpha != 0; });
    const int both = work.rows == work.columns ? work.rows : 0;
    if (hasArcs)
      ArcKernel(work).run<How>();
    else if (both == 1)
      segmentKernel<1, How>(work);
    else if (both == 2)
      segmentKernel<2, How>(work);
    else if (both == 3)
      segmentKernel<3, How>(work);
    else if (both == 4)
      segmentKernel<4, How>(work);
    else
      segmentKernel<0, How>(work);
  }
};

}  // namespace

void farMoments(const Element& e, const ElementLanes& far, Tile& moments) {
  dispatch(FarKernel{Work{e, far, moments}});
}

}  // namespace epafi::bem
