#include "bem/moments/FarPairs.hpp"

#include "bem/quadrature/Gauss.hpp"
#include "bem/quadrature/WeightedLegendre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

/// Smallest z (sum of the focal distances over the length) for which `base` points give
/// 1e-12, without the part that pays for the polynomials.
struct OrderTable {
  double smallestZ[largestSmoothOrder + 1] = {};
  OrderTable() {
    const double digits = std::log(1e12);
    smallestZ[0] = std::numeric_limits<double>::infinity();
    for (int base = 1; base <= largestSmoothOrder; ++base) {
      const double r = std::exp(digits / (2 * base));
      smallestZ[base] = 0.5 * (r + 1 / r);
    }
  }
};

// in outline diameters nothing overflows, and hypot costs as much as a whole far pair
double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// min over y in `source` of (|y-e0| + |y-e1|) / h, e0 and e1 the ends of E.
/// [doc/theory/operators.md]
double focalRatio(const Element& e, const Element& source, Vec2 middle) {
  // in a frame with E's middle as origin: `middle` is the source's middle there
  const Vec2 e1 = e.half * e.tangent;
  const Vec2 e0 = -e1;
  const auto foot = [&](Vec2 x) { return dot(x - middle, source.tangent); };
  const auto off = [&](Vec2 x) { return std::abs(dot(x - middle, source.normal)); };
  const double d0 = off(e0);
  const double d1 = off(e1);
  double t = 0;
  if (d0 + d1 > 1e-14 * e.half)
    t = (foot(e0) * d1 + foot(e1) * d0) / (d0 + d1);
  else
    t = foot({0, 0});
  t = std::clamp(t, -source.half, source.half);
  const Vec2 y = middle + t * source.tangent;
  return (length(y - e0) + length(y - e1)) / (2 * e.half);
}

double distanceToSegment(Vec2 x, Vec2 middle, const Element& segment) {
  const double t =
      std::clamp(dot(x - middle, segment.tangent), -segment.half, segment.half);
  return length(x - middle - t * segment.tangent);
}

/// Distance of two elements that do not cross; `w` from F's middle to E's.
double gap(const Element& e, const Element& f, Vec2 w) {
  const Vec2 he = e.half * e.tangent;
  const Vec2 hf = f.half * f.tangent;
  return std::min({distanceToSegment(w - he, {0, 0}, f),
                   distanceToSegment(w + he, {0, 0}, f), distanceToSegment(-hf, w, e),
                   distanceToSegment(hf, w, e)});
}

}  // namespace

int smoothOrder(double z) {
  static const OrderTable table;
  int base = 1;
  while (base < largestSmoothOrder && table.smallestZ[base] > z)
    ++base;
  return base;
}

bool isNear(const Mesh& mesh, int ie, int jf, PairOrder& order) {
  return isNear(mesh, ie, jf, mesh.difference(mesh.at(ie, 0), mesh.at(jf, 0)), order);
}

bool isNear(const Mesh& mesh, int ie, int jf, Vec2 w, PairOrder& order) {
  const Element& e = mesh[ie];
  const Element& f = mesh[jf];
  if (ie == jf || e.next == jf || f.next == ie)
    return true;
  const double distance = length(w);
  const double larger = std::max(e.half, f.half);
  if (distance - e.half - f.half < larger && gap(e, f, w) < larger)
    return true;
  // |y-e0| + |y-e1| >= 2 |y-m|: a bound that costs no projections
  double zE = (distance - f.half) / e.half;
  double zF = (distance - e.half) / f.half;
  if (zE < 4)
    zE = std::max(zE, focalRatio(e, f, -w));
  if (zF < 4)
    zF = std::max(zF, focalRatio(f, e, w));
  order = {smoothOrder(zE) + degreeShare(e.degree),
           smoothOrder(zF) + degreeShare(f.degree)};
  return false;
}

bool isNear(Vec2 w, const Element& f, int& order) {
  if (distanceToSegment(w, {0, 0}, f) < f.half)
    return true;
  const Vec2 half = f.half * f.tangent;
  order = smoothOrder((length(w - half) + length(w + half)) / (2 * f.half)) +
          degreeShare(f.degree);
  return false;
}

namespace {

struct Work {
  const Rule& outer;
  const Rule& inner;
  const WeightedLegendre& outerTable;
  const WeightedLegendre& innerTable;
  explicit Work(PairOrder order)
      : outer(gaussLegendre(order.outer)),
        inner(gaussLegendre(order.inner)),
        outerTable(weightedLegendre(order.outer)),
        innerTable(weightedLegendre(order.inner)) {}
};

/// The inner integrals at one outer point; Degree 0 for any.
template <int Degree>
struct Inner {
  static constexpr int size = (Degree > 0 ? Degree : largestDegree) + 2;
  Pack i[size];  // ∫ P_k / r²
  Pack j[size];  // ∫ P_k η / r²,  η = w·τ_F
  Pack l[size];  // ∫ P_k log r
};

template <int Degree, Division How>
EPAFI_INLINE void innerIntegrals(const Work& work, int degree, const Pack& eta0,
                                 const Pack& off2, const Pack& a, Inner<Degree>& in) {
  const int p = Degree > 0 ? Degree : degree;
  for (int k = 0; k <= p + 1; ++k)
    in.i[k] = Pack{};
  for (int q = 0; q < work.inner.size(); ++q) {
    const double* weights = work.innerTable[static_cast<std::size_t>(q)].data();
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
                            int columns, const Work& work, FarMoments& m) {
  const int pE = Degree > 0 ? Degree : rows;
  const int pF = Degree > 0 ? Degree : columns;
  const Pack tx = load(batch.tx);
  const Pack ty = load(batch.ty);
  const Pack a = load(batch.half);
  const Pack tangentOnNormal = tx * e.normal.x + ty * e.normal.y;  // τ_F·n_E
  const Pack normalOnNormal = ty * e.normal.x - tx * e.normal.y;   // n_F·n_E
  constexpr int stride = FarMoments::stride;
  const Pack zero{};
  for (int i = 0; i <= pE; ++i)
    for (int j = 0; j <= pF; ++j) {
      const int at = i * stride + j;
      store(m.log[at], zero);
      store(m.along[at], zero);
      store(m.across[at], zero);
      store(m.direct[at], zero);
      store(m.reverse[at], zero);
    }
  Inner<Degree> in{};
  for (int q = 0; q < work.outer.size(); ++q) {
    const double s = e.half * work.outer.points[q];
    const Pack wx = load(batch.wx) + s * e.tangent.x;
    const Pack wy = load(batch.wy) + s * e.tangent.y;
    const Pack eta0 = wx * tx + wy * ty;
    const Pack off = wx * ty - wy * tx;
    const Pack off2 = off * off;
    innerIntegrals<Degree, How>(work, pF, eta0, off2, a, in);
    const double* weight = work.outerTable[static_cast<std::size_t>(q)].data();
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

template <Division How>
EPAFI_INLINE void farKernelOfDegree(const Element& e, const FarBatch& batch, int rows,
                                    int columns, const Work& work, FarMoments& m) {
  if (rows == 1 && columns == 1)
    farKernel<1, How>(e, batch, rows, columns, work, m);
  else if (rows == 2 && columns == 2)
    farKernel<2, How>(e, batch, rows, columns, work, m);
  else if (rows == 3 && columns == 3)
    farKernel<3, How>(e, batch, rows, columns, work, m);
  else if (rows == 4 && columns == 4)
    farKernel<4, How>(e, batch, rows, columns, work, m);
  else
    farKernel<0, How>(e, batch, rows, columns, work, m);
}

EPAFI_AVX512 void farAvx512(const Element& e, const FarBatch& batch, int rows,
                            int columns, const Work& work, FarMoments& m) {
  farKernelOfDegree<Division::Fused>(e, batch, rows, columns, work, m);
}

EPAFI_AVX2 void farAvx2(const Element& e, const FarBatch& batch, int rows, int columns,
                        const Work& work, FarMoments& m) {
  farKernelOfDegree<Division::Fused>(e, batch, rows, columns, work, m);
}

void farBaseline(const Element& e, const FarBatch& batch, int rows, int columns,
                 const Work& work, FarMoments& m) {
  farKernelOfDegree<Division::Exact>(e, batch, rows, columns, work, m);
}

}  // namespace

void farMoments(const Element& e, const FarBatch& batch, PairDegrees degrees,
                PairOrder order, FarMoments& moments, InstructionSet set) {
  const Work work(order);
  const auto [rows, columns] = degrees;
  switch (set) {
    case InstructionSet::Avx512:
      return farAvx512(e, batch, rows, columns, work, moments);
    case InstructionSet::Avx2:
      return farAvx2(e, batch, rows, columns, work, moments);
    case InstructionSet::Baseline:
      return farBaseline(e, batch, rows, columns, work, moments);
  }
}

void extractLane(const FarMoments& far, int lane, Vec2 tangent, int rows, int columns,
                 PairMoments& moments) {
  const std::complex<double> t(tangent.x, tangent.y);
  const std::complex<double> square = t * t;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const int at = i * FarMoments::stride + j;
      if (i < rows)
        moments.direct(i, j) = far.direct[at][lane];
      if (j < columns)
        moments.reverse(i, j) = far.reverse[at][lane];
      if (i == rows || j == columns)
        continue;
      moments.log(i, j) = far.log[at][lane];
      // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²)
      const double constant = i == 0 && j == 0 ? 4 : 0;
      const std::complex<double> phase =
          square * std::complex<double>(constant - 2 * far.across[at][lane],
                                        -2 * far.along[at][lane]);
      moments.phaseReal(i, j) = phase.real();
      moments.phaseImag(i, j) = phase.imag();
    }
}

}  // namespace epafi::bem
