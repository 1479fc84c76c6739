#include "bem/operators/TileBlocks.hpp"

#include "bem/kernel/Elasticity.hpp"
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

/// What the kernels read and write.
struct Work {
  const TileMoments& m;
  const Lame& lame;
  const double* slopes;  ///< of φ_k
  const double* tangentX;
  const double* tangentY;
  const double* halves;
  const int* densityStarts;
  const int* densityCounts;
  const int* displacementStarts;
  const int* degrees;
  int last;              ///< lane
  int rows;              ///< densities on f
  int rowDegree;         ///< p_f
  int columns;           ///< the largest number of densities of the lanes
  int columnDegree;      ///< the largest degree of the lanes
  double half;           ///< of f
  const double* wanted;  ///< 1 in lanes that are, else 0
  const double* others;  ///< the same without f
  const double* bent;    ///< 1 in wanted lanes that are not on one line with f, else 0
  Index length;          ///< from column to column
  double* singleLayer;
  double* doubleLayer;
  double* slopeLayer;
  double* transposed;
  AlignedLane* halfSlopes;
};

using PackMoments = PotentialMoments<Pack>;
using PackBlock = KernelBlock<Pack>;

template <int Degree, int Rows>
class Filling {
 public:
  EPAFI_INLINE explicit Filling(const Work& work)
      : w_(work),
        densities_{work.densityStarts, work.densityCounts, work.last},
        displacements_{work.displacementStarts, work.degrees, work.last},
        wanted_(load(work.wanted)),
        bent_(load(work.bent)) {}

  EPAFI_INLINE void fill() const {
    const Pack tx = load(w_.tangentX);
    const Pack ty = load(w_.tangentY);
    const Pack squareReal = tx * tx - ty * ty;
    const Pack squareImag = 2.0 * tx * ty;
    const int rows = Rows > 0 ? Rows : w_.rows;
    const int columns = Degree > 0 ? Degree : w_.columns;
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
        if (i < (Rows > 0 ? Rows : w_.rowDegree))
          putDoubleLayer(i, j, m);
        if (j < (Degree > 0 ? Degree : w_.columnDegree))
          putTransposed(i, j, m);
      }
  }

 private:
  EPAFI_INLINE void putSymmetric(int i, int j, const PackMoments& m) const {
    const Lame& lame = w_.lame;
    const Pack area = wanted_ * w_.half * load(w_.halves);
    const PackBlock v = singleLayerBlock(lame.a, lame.b, m);
    double* single = w_.singleLayer + 2 * i * w_.length;
    densities_.put(area * v.xx, area * v.yx, j, single);
    densities_.put(area * v.xy, area * v.yy, j, single + w_.length);
    if (i >= (Rows > 0 ? Rows : w_.rowDegree) ||
        j >= (Degree > 0 ? Degree : w_.columnDegree))
      return;
    const PackBlock slope = singleLayerBlock(lame.d, lame.d, m);
    const Pack scale = wanted_ * w_.slopes[j < 1 ? 1 : j + 1];
    const Pack xx = scale * slope.xx;
    const Pack xy = scale * slope.xy;
    const Pack yy = scale * slope.yy;
    double* slopes = w_.slopeLayer + 2 * i * w_.length;
    if (i == 0 && j == 0) {
      store(w_.halfSlopes[0].lane, xx);
      store(w_.halfSlopes[1].lane, xy);
      store(w_.halfSlopes[2].lane, yy);
    }
    if (j == 0) {
      displacements_.putNodes(-xx, -xy, xx, xy, slopes);
      displacements_.putNodes(-xy, -yy, xy, yy, slopes + w_.length);
    } else {
      displacements_.put(xx, xy, j, slopes);
      displacements_.put(xy, yy, j, slopes + w_.length);
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
        w_.lame,
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
      result = (w_.slopes[k] / (2 * k - 1)) *
               (load(moments[k * step]) - load(moments[(k - 2) * step]));
  }

  // tests P_j on the lanes, source φ_k on f
  EPAFI_INLINE void putDoubleLayer(int i, int j, const PackMoments& m) const {
    const Pack half = wanted_ * load(w_.halves);
    for (int k = i == 0 ? 0 : i + 1; k <= (i == 0 ? 1 : i + 1); ++k) {
      Pack laplace;
      laplaceOf(k, w_.m.reverse + j, TileMoments::stride, laplace);
      PackBlock b{};
      doubleBlock(half, w_.slopes[k], m, laplace, b);
      double* to = w_.doubleLayer + 2 * k * w_.length;
      densities_.put(b.xx, b.yx, j, to);
      densities_.put(b.xy, b.yy, j, to + w_.length);
    }
  }

  // tests P_i on f, sources φ_k on the lanes
  EPAFI_INLINE void putTransposed(int i, int j, const PackMoments& m) const {
    const TileMoments::Lane* direct = w_.m.direct + i * TileMoments::stride;
    const Pack half = load(w_.others) * w_.half;
    double* to = w_.transposed + 2 * i * w_.length;
    Pack laplace;
    PackBlock b{};
    laplaceOf(j + 1, direct, 1, laplace);
    doubleBlock(half, w_.slopes[j + 1], m, laplace, b);
    if (j > 0) {
      displacements_.put(b.xx, b.xy, j, to);
      displacements_.put(b.yx, b.yy, j, to + w_.length);
      return;
    }
    PackBlock before{};
    laplaceOf(0, direct, 1, laplace);
    doubleBlock(half, w_.slopes[0], m, laplace, before);
    displacements_.putNodes(before.xx, before.xy, b.xx, b.xy, to);
    displacements_.putNodes(before.yx, before.yy, b.yx, b.yy, to + w_.length);
  }

  const Work& w_;
  Numbering<Degree> densities_;
  Numbering<Degree> displacements_;
  Pack wanted_;
  Pack bent_;
};

struct Fill {
  const Work& work;

  template <Division>
  EPAFI_INLINE void run() const {
    if (work.columns == 1 && work.rows == 1)
      Filling<1, 1>(work).fill();
    else if (work.columns == 1)
      Filling<1, 0>(work).fill();
    else
      Filling<0, 0>(work).fill();
  }
};

}  // namespace

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
    edges_[lane] = isThere && mesh[e].curve.isStraight() ? mesh[e].piece.edge : -1;
    densityStarts_[lane + 1] = densityStarts_[lane] + 2 * densityCounts_[lane];
    displacementStarts_[lane + 1] = displacementStarts_[lane] + 2 * degrees_[lane];
    tangentX_.lane[lane] = isThere ? mesh[e].curve.frame().tangent.x : 1;
    tangentY_.lane[lane] = isThere ? mesh[e].curve.frame().tangent.y : 0;
    halves_.lane[lane] = isThere ? mesh[e].half : 1;
  }
}

void TileBlocks::evaluate(const Tile& tile, InstructionSet set) {
  if (run_ != &tile.run())
    setRun(tile.run());
  const int f = tile.trial();
  const Element& element = space_.mesh()[f];
  AlignedLane wanted = {};
  AlignedLane others = {};
  AlignedLane bent = {};
  for (int lane = 0; lane < lanes; ++lane) {
    const bool isThere = tile.isWanted(lane);
    const bool isBent = edges_[static_cast<std::size_t>(lane)] != element.piece.edge;
    wanted.lane[lane] = isThere ? 1 : 0;
    others.lane[lane] = isThere && run_->first + lane != f ? 1 : 0;
    bent.lane[lane] = isThere && isBent ? 1 : 0;
  }
  const Work work = {tile.moments(),
                     lame_,
                     functionSlopes_.data(),
                     tangentX_.lane,
                     tangentY_.lane,
                     halves_.lane,
                     densityStarts_.data(),
                     densityCounts_.data(),
                     displacementStarts_.data(),
                     degrees_.data(),
                     run_->last - run_->first - 1,
                     element.densities,
                     element.degree,
                     run_->densities,
                     run_->degree,
                     element.half,
                     wanted.lane,
                     others.lane,
                     bent.lane,
                     longest_,
                     single_.data(),
                     double_.data(),
                     slopes_.data(),
                     transposed_.data(),
                     halfSlopes_};
  dispatch(set, Fill{work});
}

}  // namespace epafi::bem
