#include "bem/tractions/FarTractions.hpp"

#include "bem/kernel/Elasticity.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// What W and K' at x are linear in, by real and imaginary parts.
struct Parts {
  Pack conjReal;
  Pack conjImag;
  Pack cubicReal;
  Pack cubicImag;
};

struct Work {
  const FarBatch& batch;
  const Element& e;
  int moments;
  int columns;
  const Rule& outer;
  const Rule& inner;
  const WeightedLegendre& outerTable;
  const WeightedLegendre& innerTable;
};

/// The two integrals at one outer point, in the source's frame and without a: index j.
template <int Columns, Division How>
EPAFI_INLINE void sourceIntegrals(const Work& work, const Pack& eta0, const Pack& off,
                                  const Pack& a, Parts* parts) {
  const int columns = Columns > 0 ? Columns : work.columns;
  Pack over2[Columns > 0 ? Columns + 1 : largestDegree + 1];  // ∫ P_k/r²
  Pack over4[Columns > 0 ? Columns + 1 : largestDegree + 1];  // ∫ P_k/r⁴
  for (int k = 0; k <= columns; ++k)
    over2[k] = over4[k] = Pack{};
  const Pack off2 = off * off;
  for (int q = 0; q < work.inner.size(); ++q) {
    const double* weights = work.innerTable[q].data();
    const Pack eta = eta0 - a * work.inner.points[q];
    Pack inverse;
    reciprocal<How>(eta * eta + off2, inverse);
    const Pack square = inverse * inverse;
    for (int k = 0; k <= columns; ++k) {
      over2[k] += inverse * weights[k];
      over4[k] += square * weights[k];
    }
  }
  const Pack fourOff2 = 4.0 * off2;
  for (int j = 0; j < columns; ++j) {
    // t P_j = ((j+1) P_{j+1} + j P_{j-1}) / (2j+1), η = η₀ - a t
    const double up = (j + 1.0) / (2 * j + 1);
    Pack t2 = over2[j + 1] * up;
    Pack t4 = over4[j + 1] * up;
    if (j > 0) {
      const double down = static_cast<double>(j) / (2 * j + 1);
      t2 += over2[j - 1] * down;
      t4 += over4[j - 1] * down;
    }
    const Pack eta2 = eta0 * over2[j] - a * t2;  // ∫ P_j η/r²
    const Pack eta4 = eta0 * over4[j] - a * t4;  // ∫ P_j η/r⁴
    // v³ = η (r² - 4 off²) - i off (3 r² - 4 off²)
    parts[j].conjReal = eta2;
    parts[j].conjImag = -off * over2[j];
    parts[j].cubicReal = eta2 - fourOff2 * eta4;
    parts[j].cubicImag = off * (fourOff2 * over4[j] - 3.0 * over2[j]);
  }
}

EPAFI_INLINE void multiply(Pack& re, Pack& im, const Pack& x, const Pack& y) {
  const Pack real = re * x - im * y;
  im = re * y + im * x;
  re = real;
}

/// Adds a point's integrals to the moments i of one source function.
EPAFI_INLINE void addMoments(const Parts& at, const double* weights, int moments,
                             int stride, Parts* sums) {
  for (int i = 0; i < moments; ++i) {
    Parts& sum = sums[i * stride];
    sum.conjReal += at.conjReal * weights[i];
    sum.conjImag += at.conjImag * weights[i];
    sum.cubicReal += at.cubicReal * weights[i];
    sum.cubicImag += at.cubicImag * weights[i];
  }
}

/// What turns a source's frame into ours: a τ, a τ³, and 1/(2a) for slopes.
struct Turning {
  Pack x;
  Pack y;
  Pack cubeX;
  Pack cubeY;
  Pack perLength;
};

/// One moment of one source function: both operators, components of test and source.
EPAFI_INLINE void writeBlock(Parts p, const Turning& turning, const double* map,
                             double* to) {
  multiply(p.conjReal, p.conjImag, turning.x, turning.y);
  multiply(p.cubicReal, p.cubicImag, turning.cubeX, turning.cubeY);
  for (int kind = 0; kind < 2; ++kind)
    for (int component = 0; component < 2; ++component) {
      Pack result[2];
      for (int c = 0; c < 2; ++c) {
        const double* row = map + ((kind * 2 + c) * 2 + component) * 4;
        result[c] = p.conjReal * row[0] + p.conjImag * row[1] + p.cubicReal * row[2] +
                    p.cubicImag * row[3];
        if (kind == 1)
          result[c] *= turning.perLength;
      }
      interleave(result[0], result[1], to + (kind * 2 + component) * 2 * lanes);
    }
}

template <int Moments, int Columns, Division How>
EPAFI_INLINE void kernel(const Work& work, const std::array<double, 32>* map,
                         double* values) {
  const int moments = Moments > 0 ? Moments : work.moments;
  const int columns = Columns > 0 ? Columns : work.columns;
  const Pack tx = load(work.batch.tx);
  const Pack ty = load(work.batch.ty);
  const Pack a = load(work.batch.half);
  constexpr int stride = Columns > 0 ? Columns : largestDegree;
  Parts sums[Moments > 0 ? Moments * stride : (largestDegree + 1) * stride];
  for (int i = 0; i < moments; ++i)
    for (int j = 0; j < columns; ++j)
      sums[i * stride + j] = {Pack{}, Pack{}, Pack{}, Pack{}};
  for (int q = 0; q < work.outer.size(); ++q) {
    const double s = work.e.half * work.outer.points[q];
    const Pack wx = load(work.batch.wx) + s * work.e.segment().tangent.x;
    const Pack wy = load(work.batch.wy) + s * work.e.segment().tangent.y;
    Parts at[stride];
    sourceIntegrals<Columns, How>(work, wx * tx + wy * ty, wx * ty - wy * tx, a, at);
    const double* weights = work.outerTable[q].data();
    for (int j = 0; j < columns; ++j)
      addMoments(at[j], weights, moments, stride, sums + j);
  }
  Turning turning = {a * tx, a * ty, tx * tx - ty * ty, 2.0 * tx * ty, 0.5 / a};
  multiply(turning.cubeX, turning.cubeY, turning.x, turning.y);
  for (int i = 0; i < moments; ++i)
    for (int j = 0; j < columns; ++j)
      writeBlock(sums[i * stride + j], turning, map[i].data(),
                 values + (i * largestDegree + j) * 8 * lanes);
}

struct TractionKernel {
  const Work& work;
  const std::array<double, 32>* map;
  double* values;

  template <Division How>
  EPAFI_INLINE void run() const {
    if (work.moments == 2 && work.columns == 1)
      kernel<2, 1, How>(work, map, values);
    else if (work.moments == 3 && work.columns == 2)
      kernel<3, 2, How>(work, map, values);
    else
      kernel<0, 0, How>(work, map, values);
  }
};

}  // namespace

FarTractions::FarTractions(const Element& e, const Lame& lame, int moments)
    : element_(e),
      lame_(lame),
      moments_(moments),
      map_(static_cast<std::size_t>(moments)),
      values_(static_cast<std::size_t>(moments * largestDegree) * 4 * block) {
  const Complex normal = asComplex(e.curve.frame().normal);
  const Complex units[2] = {1, Complex(0, 1)};
  for (int i = 0; i < moments; ++i) {
    const double normalisation = std::sqrt(e.half * (2 * i + 1) / 2);
    double* entry = map_[i].data();
    for (int part = 0; part < 4; ++part) {
      const Complex conj = part < 2 ? units[part] : 0;
      const Complex cubic = part < 2 ? 0 : units[part - 2];
      const SourceSums in = {std::conj(conj), conj, cubic};
      for (int c = 0; c < 2; ++c) {
        const SourceSums f = units[c] * in;
        const Complex kinds[2] = {adjointDoubleLayer(lame, normal, f),
                                  hypersingular(lame, normal, f)};
        for (int kind = 0; kind < 2; ++kind) {
          entry[((kind * 2 + c) * 2 + 0) * 4 + part] = normalisation * kinds[kind].real();
          entry[((kind * 2 + c) * 2 + 1) * 4 + part] = normalisation * kinds[kind].imag();
        }
      }
    }
  }
}

void FarTractions::evaluate(const FarBatch& batch, const FarLanes& chosen,
                            InstructionSet set) {
  const int outer = outerPoints(chosen, moments_);
  const int inner = chosen.smooth.inner + polynomialShare(chosen.columns);
  const Work work = {batch,
                     element_,
                     moments_,
                     chosen.columns,
                     gaussLegendre(outer),
                     gaussLegendre(inner),
                     weightedLegendre(outer),
                     weightedLegendre(inner)};
  dispatch(set, TractionKernel{work, map_.data(), values_.data()});
}

void FarTractions::evaluateArc(const Element& source, Vec2 w, FarOrder smooth, int lane) {
  const int columns = source.degree;
  const Rule& outer = gaussLegendre(smooth.outer + polynomialShare(moments_ - 1));
  const Rule& inner = gaussLegendre(smooth.inner + polynomialShare(columns));
  const WeightedLegendre& outerTable = weightedLegendre(outer.size());
  const WeightedLegendre& innerTable = weightedLegendre(inner.size());
  const Complex units[2] = {1, Complex(0, 1)};
  for (int i = 0; i < moments_; ++i)
    for (int j = 0; j < columns; ++j)
      for (const Operator op : {Operator::Adjoint, Operator::Hypersingular})
        for (int a = 0; a < 2; ++a)
          std::fill_n(values_.data() + place(op, i, j, a) + 2 * lane, 2, 0.0);
  std::array<SourceSums, largestDegree> sums;
  for (std::size_t q = 0; q < outer.points.size(); ++q) {
    const double s = outer.points[q];
    const Complex middle = asComplex(w + element_.curve.fromMiddle(s));
    const Complex normal = asComplex(element_.curve.normal(s));
    sums.fill({});
    for (std::size_t k = 0; k < inner.points.size(); ++k) {
      const Complex d = middle - asComplex(source.curve.fromMiddle(inner.points[k]));
      const Complex conj = 1.0 / std::conj(d);
      const SourceSums at = {std::conj(conj), conj, d * conj * conj};
      for (int j = 0; j < columns; ++j)
        sums[j].add(source.half * innerTable[k][j] * at);
    }
    for (int j = 0; j < columns; ++j)
      for (int c = 0; c < 2; ++c) {
        const SourceSums f = units[c] * sums[j];
        const Complex adjoint = adjointDoubleLayer(lame_, normal, f);
        const Complex hyper = (0.5 / source.half) * hypersingular(lame_, normal, f);
        for (int i = 0; i < moments_; ++i) {
          const double factor =
              outerTable[q][i] * std::sqrt(element_.half * (2 * i + 1) / 2);
          const auto add = [&](Operator op, int a, double value) {
            values_[place(op, i, j, a) + static_cast<std::size_t>(2 * lane + c)] +=
                factor * value;
          };
          add(Operator::Adjoint, 0, adjoint.real());
          add(Operator::Adjoint, 1, adjoint.imag());
          add(Operator::Hypersingular, 0, hyper.real());
          add(Operator::Hypersingular, 1, hyper.imag());
        }
      }
  }
}

}  // namespace epafi::bem
