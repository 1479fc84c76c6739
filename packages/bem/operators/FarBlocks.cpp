#include "bem/operators/FarBlocks.hpp"

#include "bem/base/Constants.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Where the functions of the lanes stand in a column of the run; Degree 1: all lanes
/// have that degree, and every start is 2 lane.
template <int Degree>
struct Numbering {
  const int* starts;   ///< of the lanes, and behind the last
  const int* degrees;  ///< of the lanes, 0 beyond the last

  /// Writes the function j of every lane that has it.
  EPAFI_INLINE void put(const Pack& x, const Pack& y, int j, double* to) const {
    if (Degree == 1) {
      interleave(x, y, to);
      return;
    }
    for (int lane = 0; lane < lanes; ++lane)
      if (j < degrees[lane]) {
        to[starts[lane] + 2 * j] = x[lane];
        to[starts[lane] + 2 * j + 1] = y[lane];
      }
  }

  /// Writes the functions of the nodes, by what every lane gives to the node before it
  /// and to the one behind it.
  EPAFI_INLINE void putNodes(const Pack& beforeX, const Pack& beforeY,
                             const Pack& behindX, const Pack& behindY, double* to) const {
    Pack x;
    Pack y;
    shiftUp(behindX, x);
    shiftUp(behindY, y);
    put(beforeX + x, beforeY + y, 0, to);
    to[starts[lanes]] = behindX[lanes - 1];
    to[starts[lanes] + 1] = behindY[lanes - 1];
  }
};

/// What the kernels read and write.
struct Work {
  const FarMoments& m;
  const FarBatch& batch;
  const Lame& lame;
  const double* slopes;  ///< of φ_k
  const int* starts;
  const int* degrees;
  int rows;            ///< p_f
  int columns;         ///< the largest degree of the lanes
  double half;         ///< of f
  const double* far;   ///< 1 in lanes that are, else 0
  const double* bent;  ///< 1 in far lanes that are not on one line with f, else 0
  Index length;        ///< from column to column
  double* singleLayer;
  double* doubleLayer;
  double* slopeLayer;
  double* transposed;
  double* phaseReal;
  double* phaseImag;
};

/// A 2 x 2 block in every lane, by columns.
struct PackBlock {
  Pack xx;
  Pack yx;
  Pack xy;
  Pack yy;
};

/// The moments of P_i on f and P_j on the lanes.
struct Kernels {
  Pack log;
  Pack phaseReal;
  Pack phaseImag;
};

template <int Degree, int Rows>
class Filling {
 public:
  EPAFI_INLINE explicit Filling(const Work& work)
      : w_(work),
        numbering_{work.starts, work.degrees},
        far_(load(work.far)),
        bent_(load(work.bent)) {}

  EPAFI_INLINE void fill() const {
    const Pack tx = load(w_.batch.tx);
    const Pack ty = load(w_.batch.ty);
    const Pack squareReal = tx * tx - ty * ty;
    const Pack squareImag = 2.0 * tx * ty;
    const int rows = Rows > 0 ? Rows : w_.rows;
    const int columns = Degree > 0 ? Degree : w_.columns;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const int at = i * FarMoments::stride + j;
        // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²)
        const double constant = i == 0 && j == 0 ? 4 : 0;
        const Pack real = constant - 2.0 * load(w_.m.across[at]);
        const Pack imag = -2.0 * load(w_.m.along[at]);
        const Kernels k = {load(w_.m.log[at]), squareReal * real - squareImag * imag,
                           squareReal * imag + squareImag * real};
        if (i == 0 && j == 0) {
          store(w_.phaseReal, k.phaseReal);
          store(w_.phaseImag, k.phaseImag);
        }
        putSymmetric(i, j, constant, k);
        putDoubleLayer(i, j, k);
        putTransposed(i, j, k);
      }
  }

 private:
  // V = A (-log r) + B d d'/r² and V* = D (-log r + d d'/r²), d d'/r² = (I + [Re, Im; Im,
  // -Re] of w/conj(w)) / 2
  EPAFI_INLINE void putSymmetric(int i, int j, double constant, const Kernels& k) const {
    const Lame& lame = w_.lame;
    const Pack radialX = 0.5 * (constant + k.phaseReal);
    const Pack radialY = 0.5 * (constant - k.phaseReal);
    const Pack radialXY = 0.5 * k.phaseImag;
    const Pack area = far_ * w_.half * load(w_.batch.half);
    const Pack xy = area * lame.b * radialXY;
    double* single = w_.singleLayer + 2 * i * w_.length;
    numbering_.put(area * (lame.b * radialX - lame.a * k.log), xy, j, single);
    numbering_.put(xy, area * (lame.b * radialY - lame.a * k.log), j, single + w_.length);

    const Pack d = far_ * lame.d * w_.slopes[j < 1 ? 1 : j + 1];
    const Pack slopeXX = d * (radialX - k.log);
    const Pack slopeXY = d * radialXY;
    const Pack slopeYY = d * (radialY - k.log);
    double* slopes = w_.slopeLayer + 2 * i * w_.length;
    if (j == 0) {
      numbering_.putNodes(-slopeXX, -slopeXY, slopeXX, slopeXY, slopes);
      numbering_.putNodes(-slopeXY, -slopeYY, slopeXY, slopeYY, slopes + w_.length);
    } else {
      numbering_.put(slopeXX, slopeXY, j, slopes);
      numbering_.put(slopeXY, slopeYY, j, slopes + w_.length);
    }
  }

  // K(P e_c, φ e_b), see Scatter::addDoubleLayer; `half` of the test's element
  EPAFI_INLINE void doubleBlock(const Pack& half, double slope, const Kernels& k,
                                const Pack& laplace, PackBlock& block) const {
    const Lame& lame = w_.lame;
    const Pack ofLog = half * (2 * lame.mu * (1 - 2 * lame.nu) * lame.b * slope);
    const Pack ofPhase = half * bent_ * (lame.mu * lame.b * slope);
    const Pack re = ofPhase * k.phaseReal;
    const Pack im = ofPhase * k.phaseImag;
    const Pack log = ofLog * k.log;
    const Pack l = half * bent_ * inverse2Pi * laplace;
    block = {im + l, -re - log, log - re, l - im};
  }

  /// ∫∫ P φ_k of the Laplace double layer from those of Legendre polynomials.
  EPAFI_INLINE void laplaceOf(int k, const FarMoments::Lane* moments, int step,
                              Pack& result) const {
    if (k == 0)
      result = 0.5 * (load(moments[0]) - load(moments[step]));
    else if (k == 1)
      result = 0.5 * (load(moments[0]) + load(moments[step]));
    else
      result = (w_.slopes[k] / (2 * k - 1)) *
               (load(moments[k * step]) - load(moments[(k - 2) * step]));
  }

  // tests P_j on the lanes, source φ_k on f
  EPAFI_INLINE void putDoubleLayer(int i, int j, const Kernels& kernels) const {
    const Pack half = far_ * load(w_.batch.half);
    for (int k = i == 0 ? 0 : i + 1; k <= (i == 0 ? 1 : i + 1); ++k) {
      Pack laplace;
      laplaceOf(k, w_.m.reverse + j, FarMoments::stride, laplace);
      PackBlock b{};
      doubleBlock(half, w_.slopes[k], kernels, laplace, b);
      double* to = w_.doubleLayer + 2 * k * w_.length;
      numbering_.put(b.xx, b.yx, j, to);
      numbering_.put(b.xy, b.yy, j, to + w_.length);
    }
  }

  // tests P_i on f, sources φ_k on the lanes
  EPAFI_INLINE void putTransposed(int i, int j, const Kernels& kernels) const {
    const FarMoments::Lane* direct = w_.m.direct + i * FarMoments::stride;
    const Pack half = far_ * w_.half;
    double* to = w_.transposed + 2 * i * w_.length;
    Pack laplace;
    PackBlock b{};
    laplaceOf(j + 1, direct, 1, laplace);
    doubleBlock(half, w_.slopes[j + 1], kernels, laplace, b);
    if (j > 0) {
      numbering_.put(b.xx, b.xy, j, to);
      numbering_.put(b.yx, b.yy, j, to + w_.length);
      return;
    }
    PackBlock before{};
    laplaceOf(0, direct, 1, laplace);
    doubleBlock(half, w_.slopes[0], kernels, laplace, before);
    numbering_.putNodes(before.xx, before.xy, b.xx, b.xy, to);
    numbering_.putNodes(before.yx, before.yy, b.yx, b.yy, to + w_.length);
  }

  const Work& w_;
  Numbering<Degree> numbering_;
  Pack far_;
  Pack bent_;
};

EPAFI_INLINE void fillOfDegree(const Work& work, bool linear) {
  if (linear && work.rows == 1)
    Filling<1, 1>(work).fill();
  else if (linear)
    Filling<1, 0>(work).fill();
  else
    Filling<0, 0>(work).fill();
}

EPAFI_AVX512 void fillAvx512(const Work& work, bool linear) {
  fillOfDegree(work, linear);
}

EPAFI_AVX2 void fillAvx2(const Work& work, bool linear) { fillOfDegree(work, linear); }

void fillBaseline(const Work& work, bool linear) { fillOfDegree(work, linear); }

}  // namespace

FarBlocks::FarBlocks(const Space& space, const Lame& lame)
    : space_(space), lame_(lame), moments_(std::make_unique<FarMoments>()) {
  for (int k = 0; k <= largestDegree; ++k)
    functionSlopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
  int degree = 1;
  for (const Element& element : space.mesh().elements())
    degree = std::max(degree, element.degree);
  longest_ = 2 * lanes * degree + 2;
  for (Vector* columns : {&single_, &double_, &slopes_, &transposed_})
    columns->resize(static_cast<std::size_t>(2 * (degree + 1) * longest_));
}

void FarBlocks::setRun(const ElementRun& run) {
  const Mesh& mesh = space_.mesh();
  runDegree_ = run.degree;
  starts_[0] = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int e = run.first + static_cast<int>(lane);
    const bool isThere = e < run.last;
    degrees_[lane] = isThere ? mesh[e].degree : 0;
    edges_[lane] = isThere ? mesh[e].piece.edge : -1;
    starts_[lane + 1] = starts_[lane] + 2 * degrees_[lane];
  }
}

void FarBlocks::evaluate(int f, const FarLanes& chosen, const FarBatch& batch,
                         InstructionSet set) {
  const Element& element = space_.mesh()[f];
  // all of the run's functions, since those of near lanes are zeros to write, too
  farMoments(element, batch, {element.degree, runDegree_},
             {chosen.smooth.outer + degreeShare(element.degree),
              chosen.smooth.inner + degreeShare(runDegree_)},
             *moments_, set);
  alignas(64) double far[lanes];
  alignas(64) double bent[lanes];
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    far[lane] = chosen.far[lane] ? 1 : 0;
    bent[lane] = edges_[lane] != element.piece.edge ? far[lane] : 0;
  }
  const Work work = {*moments_,      batch,
                     lame_,          functionSlopes_.data(),
                     starts_.data(), degrees_.data(),
                     element.degree, runDegree_,
                     element.half,   far,
                     bent,           longest_,
                     single_.data(), double_.data(),
                     slopes_.data(), transposed_.data(),
                     phaseReal_,     phaseImag_};
  const bool linear = runDegree_ == 1;
  switch (set) {
    case InstructionSet::Avx512:
      return fillAvx512(work, linear);
    case InstructionSet::Avx2:
      return fillAvx2(work, linear);
    case InstructionSet::Baseline:
      return fillBaseline(work, linear);
  }
}

}  // namespace epafi::bem
