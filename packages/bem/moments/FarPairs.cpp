#include "bem/moments/FarPairs.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

namespace epafi::bem {

namespace {

/// The inner integrals at one outer point; Degree 0 for any.
template <int Degree>
struct Inner {
  static constexpr int size = (Degree > 0 ? Degree : largestMoment) + 2;
  Pack i[size];  // ∫ P_k / r²
  Pack j[size];  // ∫ P_k η / r²,  η = w·τ_F
  Pack l[size];  // ∫ P_k log r
};

template <int Degree, Division How>
EPAFI_INLINE void innerIntegrals(const FarRules& work, int degree, const Pack& eta0,
                                 const Pack& off2, const Pack& a, Inner<Degree>& in) {
  const int p = Degree > 0 ? Degree : degree;
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
}

template <int Degree, Division How>
EPAFI_INLINE void farKernel(const Element& e, const FarBatch& batch, int rows,
                            int columns, const FarRules& work, TileMoments& m) {
  const int pE = Degree > 0 ? Degree : rows;
  const int pF = Degree > 0 ? Degree : columns;
  const Pack tx = load(batch.tx);
  const Pack ty = load(batch.ty);
  const Pack a = load(batch.half);
  const Pack tangentOnNormal =
      tx * e.segment().normal.x + ty * e.segment().normal.y;  // τ_F·n_E
  const Pack normalOnNormal =
      ty * e.segment().normal.x - tx * e.segment().normal.y;  // n_F·n_E
  constexpr int stride = TileMoments::stride;
  m.clear(pE, pF);
  Inner<Degree> in{};
  for (int q = 0; q < work.outer.size(); ++q) {
    const double s = e.half * work.outer.points[q];
    const Pack wx = load(batch.wx) + s * e.segment().tangent.x;
    const Pack wy = load(batch.wy) + s * e.segment().tangent.y;
    const Pack eta0 = wx * tx + wy * ty;
    const Pack off = wx * ty - wy * tx;
    const Pack off2 = off * off;
    innerIntegrals<Degree, How>(work, pF, eta0, off2, a, in);
    const double* weight = work.outerTable[q].data();
    for (int j = 0; j <= pF; ++j) {
      const Pack offI = off * in.i[j];
      const Pack direct = a * offI;
      const Pack along = off * in.j[j];
      const Pack across = off * offI;
      const Pack reverse = -e.half * (tangentOnNormal * in.j[j] + normalOnNormal * offI);
      for (int i = 0; i < pE; ++i)
        add(m.direct[i * stride + j], direct * weight[i]);
      if (j == pF)
        continue;
      for (int i = 0; i < pE; ++i) {
        const int at = i * stride + j;
        add(m.log[at], in.l[j] * weight[i]);
        add(m.along[at], along * weight[i]);
        add(m.across[at], across * weight[i]);
      }
      for (int i = 0; i <= pE; ++i)
        add(m.reverse[i * stride + j], reverse * weight[i]);
    }
  }
}

/// The kernel for the degrees at hand.
struct FarKernel {
  const Element& e;
  const FarBatch& batch;
  PairDegrees degrees;
  const FarRules& work;
  TileMoments& m;

  template <Division How>
  EPAFI_INLINE void run() const {
    const auto [rows, columns] = degrees;
    const int both = rows == columns ? rows : 0;
    if (both == 1)
      farKernel<1, How>(e, batch, rows, columns, work, m);
    else if (both == 2)
      farKernel<2, How>(e, batch, rows, columns, work, m);
    else if (both == 3)
      farKernel<3, How>(e, batch, rows, columns, work, m);
    else if (both == 4)
      farKernel<4, How>(e, batch, rows, columns, work, m);
    else
      farKernel<0, How>(e, batch, rows, columns, work, m);
  }
};

}  // namespace

void farMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                FarOrder order, TileMoments& moments, InstructionSet set) {
  const FarRules work(order, degrees);
  dispatch(set, FarKernel{e, batch, degrees, work, moments});
}

}  // namespace epafi::bem
