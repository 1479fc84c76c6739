#include "bem/operators/TileBlocks.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Where the functions of the lanes stand in a column of the run; Degree 1: all lanes
/// have one, and every start is 2 lane.
template <int Degree>
struct Numbering {
  const int* starts;  ///< of the lanes, and behind the last
  const int* counts;  ///< of the lanes, 0 beyond the last
  int last;           ///< lane

  /// Writes the function j of every lane that has it.
  EPAFI_INLINE void put(const Pack& x, const Pack& y, int j, double* to) const {
    if (Degree == 1) {
      interleave(x, y, to);
      return;
    }
    for (int lane = 0; lane < lanes; ++lane)
      if (j < counts[lane]) {
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
    to[starts[lanes]] = behindX[last];
    to[starts[lanes] + 1] = behindY[last];
  }
};

using PackMoments = PotentialMoments<Pack>;
using PackBlock = KernelBlock<Pack>;

}  // namespace

/// What the kernels read and write.
struct TileBlocks::Work {
  TileBlocks& to;
  const TileMoments& m;
  const Element& f;
  AlignedLane wanted = {};  ///< 1 in lanes that are, else 0
  AlignedLane others = {};  ///< the same without f
  AlignedLane bent = {};    ///< 1 in wanted lanes that are not on one line with f, else 0
};

template <int Degree, int Rows>
class TileBlocks::Filling {
 public:
  EPAFI_INLINE explicit Filling(const Work& work)
      : w_(work),
        to_(work.to),
        densities_{to_.densityStarts_.data(), to_.densityCounts_.data(), to_.lastLane()},
        displacements_{to_.displacementStarts_.data(), to_.degrees_.data(),
                       to_.lastLane()},
        wanted_(load(work.wanted.lane)),
        bent_(load(work.bent.lane)) {}

  EPAFI_INLINE void fill() const {
    const Pack tx = load(to_.run_->elements.tx);
    const Pack ty = load(to_.run_->elements.ty);
    const Pack squareReal = tx * tx - ty * ty;
    const Pack squareImag = 2.0 * tx * ty;
    const int rows = Rows > 0 ? Rows : w_.f.densities;
    const int columns = Degree > 0 ? Degree : to_.run_->densities;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const int at = i * TileMoments::stride + j;
        // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²)
        const double constant = i == 0 && j == 0 ? 4 : 0;
        const Pack real = constant - 2.0 * load(w_.m.across[at]);
        const Pack imag = -2.0 * load(w_.m.along[at]);
        const PackMoments m = {load(w_.m.log[at]), squareReal * real - squareImag * imag,
                               squareReal * imag + squareImag * real, constant};
        putSymmetric(i, j, m);
        if (i < (Rows > 0 ? Rows : w_.f.degree))
          putDoubleLayer(i, j, m);
        if (j < (Degree > 0 ? Degree : to_.run_->degree))
          putTransposed(i, j, m);
      }
  }

 private:
  EPAFI_INLINE void putSymmetric(int i, int j, const PackMoments& m) const {
    const Lame& lame = to_.lame_;
    const Pack area = wanted_ * w_.f.half * load(to_.run_->elements.half);
    const PackBlock v = singleLayerBlock(lame.a, lame.b, m);
    double* single = to_.single_.data() + 2 * i * to_.longest_;
    densities_.put(area * v.xx, area * v.yx, j, single);
    densities_.put(area * v.xy, area * v.yy, j, single + to_.longest_);
    if (i >= (Rows > 0 ? Rows : w_.f.degree) ||
        j >= (Degree > 0 ? Degree : to_.run_->degree))
      return;
    const PackBlock slope = singleLayerBlock(lame.d, lame.d, m);
    const Pack scale = wanted_ * to_.functionSlopes_[j < 1 ? 1 : j + 1];
    const Pack xx = scale * slope.xx;
    const Pack xy = scale * slope.xy;
    const Pack yy = scale * slope.yy;
    double* slopes = to_.slopes_.data() + 2 * i * to_.longest_;
    if (i == 0 && j == 0) {
      store(to_.halfSlopes_[0].lane, xx);
      store(to_.halfSlopes_[1].lane, xy);
      store(to_.halfSlopes_[2].lane, yy);
    }
    if (j == 0) {
      displacements_.putNodes(-xx, -xy, xx, xy, slopes);
      displacements_.putNodes(-xy, -yy, xy, yy, slopes + to_.longest_);
    } else {
      displacements_.put(xx, xy, j, slopes);
      displacements_.put(xy, yy, j, slopes + to_.longest_);
    }
  }

  // On one line K_Δ vanishes, and the phase is one constant, whose contributions of
  // neighbours cancel at every node but the edge's ends: adding and subtracting it would
  // leave rounding, which is large beside the rest as ν -> 1/2.  `half` of the test's
  // element.
  EPAFI_INLINE void doubleBlock(const Pack& half, double slope, const PackMoments& m,
                                const Pack& laplace, PackBlock& block) const {
    const Pack bent = slope * bent_;
    block = doubleLayerBlock(
        to_.lame_,
        PackMoments{slope * m.log, bent * m.phaseReal, bent * m.phaseImag, m.whole},
        bent_ * laplace);
    block = {half * block.xx, half * block.yx, half * block.xy, half * block.yy};
  }

  /// ∫∫ P φ_k of the Laplace double layer from those of Legendre polynomials.
  EPAFI_INLINE void laplaceOf(int k, const TileMoments::Lane* moments, int step,
                              Pack& result) const {
    if (k == 0)
      result = 0.5 * (load(moments[0]) - load(moments[step]));
    else if (k == 1)
      result = 0.5 * (load(moments[0]) + load(moments[step]));
    else
      result = (to_.functionSlopes_[k] / (2 * k - 1)) *
               (load(moments[k * step]) - load(moments[(k - 2) * step]));
  }

  // tests P_j on the lanes, source φ_k on f
  EPAFI_INLINE void putDoubleLayer(int i, int j, const PackMoments& m) const {
    const Pack half = wanted_ * load(to_.run_->elements.half);
    for (int k = i == 0 ? 0 : i + 1; k <= (i == 0 ? 1 : i + 1); ++k) {
      Pack laplace;
      laplaceOf(k, w_.m.reverse + j, TileMoments::stride, laplace);
      PackBlock b{};
      doubleBlock(half, to_.functionSlopes_[k], m, laplace, b);
      double* to = to_.double_.data() + 2 * k * to_.longest_;
      densities_.put(b.xx, b.yx, j, to);
      densities_.put(b.xy, b.yy, j, to + to_.longest_);
    }
  }

  // tests P_i on f, sources φ_k on the lanes
  EPAFI_INLINE void putTransposed(int i, int j, const PackMoments& m) const {
    const TileMoments::Lane* direct = w_.m.direct + i * TileMoments::stride;
    const Pack half = load(w_.others.lane) * w_.f.half;
    double* to = to_.transposed_.data() + 2 * i * to_.longest_;
    Pack laplace;
    PackBlock b{};
    laplaceOf(j + 1, direct, 1, laplace);
    doubleBlock(half, to_.functionSlopes_[j + 1], m, laplace, b);
    if (j > 0) {
      displacements_.put(b.xx, b.xy, j, to);
      displacements_.put(b.yx, b.yy, j, to + to_.longest_);
      return;
    }
    PackBlock before{};
    laplaceOf(0, direct, 1, laplace);
    doubleBlock(half, to_.functionSlopes_[0], m, laplace, before);
    displacements_.putNodes(before.xx, before.xy, b.xx, b.xy, to);
    displacements_.putNodes(before.yx, before.yy, b.yx, b.yy, to + to_.longest_);
  }

  const Work& w_;
  TileBlocks& to_;
  Numbering<Degree> densities_;
  Numbering<Degree> displacements_;
  Pack wanted_;
  Pack bent_;
};

struct TileBlocks::Fill {
  const Work& work;

  template <Division>
  EPAFI_INLINE void run() const {
    const int columns = work.to.run_->densities;
    if (columns == 1 && work.f.densities == 1)
      Filling<1, 1>(work).fill();
    else if (columns == 1)
      Filling<1, 0>(work).fill();
    else
      Filling<0, 0>(work).fill();
  }
};

TileBlocks::TileBlocks(const Space& space, const Lame& lame)
    : space_(space), lame_(lame) {
  for (int k = 0; k <= largestDegree; ++k)
    functionSlopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
  int functions = 1;
  for (const Element& element : space.mesh().elements())
    functions = std::max(functions, element.densities);
  longest_ = 2 * lanes * functions + 2;
  for (Vector* columns : {&single_, &double_, &slopes_, &transposed_})
    columns->resize(static_cast<std::size_t>(2 * (functions + 1) * longest_));
}

void TileBlocks::setRun(const ElementRun& run) {
  const Mesh& mesh = space_.mesh();
  run_ = &run;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int e = run.first + static_cast<int>(lane);
    const bool isThere = e < run.last;
    degrees_[lane] = isThere ? mesh[e].degree : 0;
    densityCounts_[lane] = isThere ? mesh[e].densities : 0;
    lines_[lane] = isThere ? mesh.lineOf(e) : -1;
    densityStarts_[lane + 1] = densityStarts_[lane] + 2 * densityCounts_[lane];
    displacementStarts_[lane + 1] = displacementStarts_[lane] + 2 * degrees_[lane];
  }
}

void TileBlocks::evaluate(const Tile& tile, InstructionSet set) {
  if (run_ != &tile.run())
    setRun(tile.run());
  const int f = tile.trial();
  Work work = {*this, tile.moments(), space_.mesh()[f]};
  for (int lane = 0; lane < lanes; ++lane) {
    const bool isThere = tile.isWanted(lane);
    const bool isBent = lines_[static_cast<std::size_t>(lane)] != work.f.piece.edge;
    work.wanted.lane[lane] = isThere ? 1 : 0;
    work.others.lane[lane] = isThere && run_->first + lane != f ? 1 : 0;
    work.bent.lane[lane] = isThere && isBent ? 1 : 0;
  }
  dispatch(set, Fill{work});
}

}  // namespace epafi::bem
