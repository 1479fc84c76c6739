#include "bem/operators/TileBlocks.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

using PackBlock = KernelBlock<Pack>;

/// Is node k of an element on a line an end of its edge?
bool endsEdge(const Mesh& mesh, int e, int k) {
  return mesh.lineOf(e) >= 0 &&
         !mesh.areOnLine(k == 0 ? mesh[e].previous : mesh[e].next, e);
}

}  // namespace

/// What the kernels read and write.
struct TileBlocks::Work {
  TileBlocks& to;
  const Tile& m;
  const Element& f;
  AlignedLane wanted = {};  ///< 1 in lanes that are, else 0
  AlignedLane others = {};  ///< the same without f
  AlignedLane bent = {};    ///< 1 in wanted lanes that are not on one line with f, else 0
  bool endsEdge[2] = {};    ///< the first, the last node of f
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
    const ComplexPack tangent{load(to_.run_->tx), load(to_.run_->ty)};
    const ComplexPack square = tangent * tangent;
    const int rows = Rows > 0 ? Rows : w_.f.densities;
    const int columns = Degree > 0 ? Degree : to_.run_->densities;
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const int at = i * Tile::stride + j;
        // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²)
        const Pack log = load(w_.m.log[at]);
        const ComplexPack phase =
            square * ComplexPack{wholeOf(i, j) - 2.0 * load(w_.m.across[at]),
                                 -2.0 * load(w_.m.along[at])};
        putSymmetric(i, j, log, phase);
        if (i < (Rows > 0 ? Rows : w_.f.degree))
          putDoubleLayer(i, j, log, phase);
        if (j < (Degree > 0 ? Degree : to_.run_->degree))
          putTransposed(i, j, log, phase);
      }
  }

 private:
  /// ∫∫ P_i P_j
  EPAFI_INLINE static double wholeOf(int i, int j) { return i == 0 && j == 0 ? 4 : 0; }

  EPAFI_INLINE void putSymmetric(int i, int j, const Pack& log,
                                 const ComplexPack& phase) const {
    const Lame& lame = to_.lame_;
    const double whole = wholeOf(i, j);
    const Pack area = wanted_ * w_.f.half * load(to_.run_->half);
    const PackBlock v = singleLayerBlock(lame.a, lame.b, log, phase, whole);
    double* single = to_.single_.data() + 2 * i * to_.longest_;
    densities_.put(area * v.xx, area * v.yx, j, single);
    densities_.put(area * v.xy, area * v.yy, j, single + to_.longest_);
    if (i >= (Rows > 0 ? Rows : w_.f.degree) ||
        j >= (Degree > 0 ? Degree : to_.run_->degree))
      return;
    const PackBlock slope = singleLayerBlock(lame.d, lame.d, log, phase, whole);
    const Pack scale = wanted_ * to_.functionSlopes_[j < 1 ? 1 : j + 1];
    const Pack xx = scale * slope.xx;
    const Pack xy = scale * slope.xy;
    const Pack yy = scale * slope.yy;
    double* slopes = to_.hypersingular_.data() + 2 * i * to_.longest_;
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
  // element; `phases`: 1 where the phase counts, else 0.
  // NOLINTNEXTLINE(readability-function-*): of one formula
  EPAFI_INLINE void doubleBlock(const Pack& half, double slope, const Pack& phases,
                                const Pack& log, const ComplexPack& phase,
                                const Pack& laplace, PackBlock& block) const {
    const Pack ofLog = slope * log;
    const Pack counted = slope * phases;
    const Pack ofLaplace = bent_ * laplace;
    block = doubleLayerBlock(to_.lame_, ofLog, counted * phase, ofLaplace);
    block = {half * block.xx, half * block.yx, half * block.xy, half * block.yy};
  }

  /// ∫∫ P φ_k of the Laplace double layer from those of Legendre polynomials.
  EPAFI_INLINE void laplaceOf(int k, const Tile::Lane* moments, int step,
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
  EPAFI_INLINE void putDoubleLayer(int i, int j, const Pack& log,
                                   const ComplexPack& phase) const {
    const Pack half = wanted_ * load(to_.run_->half);
    for (int k = i == 0 ? 0 : i + 1; k <= (i == 0 ? 1 : i + 1); ++k) {
      Pack laplace;
      laplaceOf(k, w_.m.reverse + j, Tile::stride, laplace);
      PackBlock b{};
      const Pack& phases = k < 2 && w_.endsEdge[k] ? wanted_ : bent_;
      doubleBlock(half, to_.functionSlopes_[k], phases, log, phase, laplace, b);
      double* to = to_.double_.data() + 2 * k * to_.longest_;
      densities_.put(b.xx, b.yx, j, to);
      densities_.put(b.xy, b.yy, j, to + to_.longest_);
    }
  }

  // tests P_i on f, sources φ_k on the lanes
  EPAFI_INLINE void putTransposed(int i, int j, const Pack& log,
                                  const ComplexPack& phase) const {
    const Tile::Lane* direct = w_.m.direct + i * Tile::stride;
    const Pack half = load(w_.others.lane) * w_.f.half;
    double* to = to_.transposed_.data() + 2 * i * to_.longest_;
    // with the phase where a node ends its edge
    const Pack line = wanted_ - bent_;
    const Pack before = bent_ + line * load(to_.endsEdge_[0].lane);
    const Pack behind = bent_ + line * load(to_.endsEdge_[1].lane);
    Pack laplace;
    PackBlock b{};
    laplaceOf(j + 1, direct, 1, laplace);
    doubleBlock(half, to_.functionSlopes_[j + 1], j == 0 ? behind : bent_, log, phase,
                laplace, b);
    if (j > 0) {
      displacements_.put(b.xx, b.xy, j, to);
      displacements_.put(b.yx, b.yy, j, to + to_.longest_);
      return;
    }
    PackBlock a{};
    laplaceOf(0, direct, 1, laplace);
    doubleBlock(half, to_.functionSlopes_[0], before, log, phase, laplace, a);
    displacements_.putNodes(a.xx, a.xy, b.xx, b.xy, to);
    displacements_.putNodes(a.yx, a.yy, b.yx, b.yy, to + to_.longest_);
  }

  const Work& w_;
  TileBlocks& to_;
  ColumnNumbering<Degree> densities_;
  ColumnNumbering<Degree> displacements_;
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
    : PairColumns(space), lame_(lame) {}

void TileBlocks::setRun(const ElementLanes& run, int trial) {
  if (!PairColumns::setRun(run, trial))
    return;
  const Mesh& mesh = space_.mesh();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const int e = run.first + static_cast<int>(lane);
    const bool isThere = e < run.last;
    lines_[lane] = isThere ? mesh.lineOf(e) : -1;
    for (int k = 0; k < 2; ++k)
      endsEdge_[k].lane[lane] = isThere && endsEdge(mesh, e, k) ? 1 : 0;
  }
}

void TileBlocks::evaluate(const Tile& tile, InstructionSet set) {
  setRun(tile.run(), tile.trial());
  const int f = tile.trial();
  const Mesh& mesh = space_.mesh();
  Work work = {*this, tile, mesh[f]};
  for (int k = 0; k < 2; ++k)
    work.endsEdge[k] = endsEdge(mesh, f, k);
  for (int lane = 0; lane < lanes; ++lane) {
    const bool isThere = tile.isWanted(lane);
    const bool isBent = lines_[static_cast<std::size_t>(lane)] != work.f.piece.edge;
    work.wanted.lane[lane] = isThere ? 1 : 0;
    work.others.lane[lane] = isThere && run_->first + lane != f ? 1 : 0;
    work.bent.lane[lane] = isThere && isBent ? 1 : 0;
  }
  dispatch(set, Fill{work});
  if (tile.isWanted(f - run_->first))
    addHalf(massOf(mesh[f]));
}

}  // namespace epafi::bem
