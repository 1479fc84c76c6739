#include "bem/moments/FarPairs.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

namespace epafi::bem {

namespace {

/// sin(x)/x and cos x for |x| <= π/4, by their series.
EPAFI_INLINE void sineCosine(const Pack& x, Pack& sinc, Pack& cosine) {
  const Pack z = -x * x;
  sinc = z * (1.0 / (18 * 19)) + 1.0;
  cosine = z * (1.0 / (17 * 18)) + 1.0;
#pragma GCC unroll 8
  for (int k = 8; k >= 1; --k) {
    sinc = sinc * z * (1.0 / (2 * k * (2 * k + 1))) + 1.0;
    cosine = cosine * z * (1.0 / ((2 * k - 1) * 2 * k)) + 1.0;
  }
}

/// A Gauss point of every lane: its place relative to the middle and its normal, times half
/// the element's length.
struct InnerPoint {
  Pack x;
  Pack y;
  Pack normalX;
  Pack normalY;

  EPAFI_INLINE void set(const FarBatch& batch, double t) {
    const Pack half = load(batch.half);
    const Pack tx = load(batch.tx);
    const Pack ty = load(batch.ty);
    Pack sinc;
    Pack cosine;
    const Pack angle = (0.5 * t) * load(batch.alpha);
    sineCosine(angle, sinc, cosine);
    const Pack sine = angle * sinc;
    const Pack along = (half * t) * sinc * cosine;
    const Pack across = (half * t) * sinc * sine;
    x = along * tx - across * ty;
    y = along * ty + across * tx;
    const Pack sine2 = 2.0 * sine * cosine;
    const Pack cosine2 = 1.0 - 2.0 * sine * sine;
    // the tangent turned by twice the angle, then to the right
    normalX = half * (cosine2 * ty + sine2 * tx);
    normalY = half * (sine2 * ty - cosine2 * tx);
  }
};

/// ∫ P_j of the five integrands at one outer point.
struct InnerSums {
  Pack log[largestMoment + 2];
  Pack along[largestMoment + 2];
  Pack across[largestMoment + 2];
  Pack direct[largestMoment + 2];
  Pack reverse[largestMoment + 2];
};

struct ArcKernel {
  const Element& e;
  const FarBatch& batch;
  PairDegrees degrees;
  const FarRules& rules;
  TileMoments& m;

  template <Division How>
  EPAFI_INLINE void run() const {
    m.clear(degrees.rows, degrees.columns);
    InnerPoint points[largestGaussOrder];
    for (int q = 0; q < rules.inner.size(); ++q)
      points[q].set(batch, rules.inner.points[q]);
    InnerSums in;
    for (int q = 0; q < rules.outer.size(); ++q) {
      const double s = rules.outer.points[q];
      const Vec2 offset = e.curve.fromMiddle(s);
      const Vec2 normal = e.half * e.curve.normal(s);
      integrate<How>(offset, normal, points, in);
      addMoments(in, rules.outerTable[q].data());
    }
  }

 private:
  static constexpr int stride = TileMoments::stride;

  template <Division How>
  EPAFI_INLINE void integrate(const Vec2& offset, const Vec2& normal,
                              const InnerPoint* points, InnerSums& in) const {
    const int columns = degrees.columns;
    for (int j = 0; j <= columns; ++j)
      in.log[j] = in.along[j] = in.across[j] = in.direct[j] = in.reverse[j] = Pack{};
    const Pack tx = load(batch.tx);
    const Pack ty = load(batch.ty);
    const Pack middleX = load(batch.wx) + offset.x;
    const Pack middleY = load(batch.wy) + offset.y;
    for (int q = 0; q < rules.inner.size(); ++q) {
      const InnerPoint& y = points[q];
      const double* weights = rules.innerTable[q].data();
      const Pack wx = middleX - y.x;
      const Pack wy = middleY - y.y;
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
      const Pack direct = (wx * y.normalX + wy * y.normalY) * inverse;
      const Pack reverse = -(wx * normal.x + wy * normal.y) * inverse;
      for (int j = 0; j <= columns; ++j) {
        in.log[j] += log * weights[j];
        in.along[j] += along * weights[j];
        in.across[j] += across * weights[j];
        in.direct[j] += direct * weights[j];
        in.reverse[j] += reverse * weights[j];
      }
    }
  }

  EPAFI_INLINE void addMoments(const InnerSums& in, const double* weight) const {
    const auto [rows, columns] = degrees;
    for (int j = 0; j <= columns; ++j) {
      for (int i = 0; i < rows; ++i)
        add(m.direct[i * stride + j], in.direct[j] * weight[i]);
      if (j == columns)
        continue;
      for (int i = 0; i < rows; ++i) {
        const int at = i * stride + j;
        add(m.log[at], in.log[j] * weight[i]);
        add(m.along[at], in.along[j] * weight[i]);
        add(m.across[at], in.across[j] * weight[i]);
      }
      for (int i = 0; i <= rows; ++i)
        add(m.reverse[i * stride + j], in.reverse[j] * weight[i]);
    }
  }
};

}  // namespace

void farArcMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                   FarOrder order, TileMoments& moments, InstructionSet set) {
  const FarRules rules(order, degrees);
  dispatch(set, ArcKernel{e, batch, degrees, rules, moments});
}

}  // namespace epafi::bem
