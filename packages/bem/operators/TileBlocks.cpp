#include "bem/operators/TileBlocks.hpp"

#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

namespace {

using Block = KernelBlock<Pack>;
using Scalar = ScalarBlock<Pack>;

EPAFI_INLINE Block operator*(const Pack& s, const Block& b) {
  return {s * b.xx, s * b.yx, s * b.xy, s * b.yy};
}
EPAFI_INLINE Scalar operator*(const Pack& s, const Scalar& b) { return {s * b.value}; }

EPAFI_INLINE Block mirrored(const Block& b) { return {b.xx, b.xy, b.yx, b.yy}; }
EPAFI_INLINE Scalar mirrored(const Scalar& b) { return b; }

/// Writes the function j of all columns of a block, `stride` from one to the next.
template <class Numbering>
EPAFI_INLINE void put(const Numbering& to, const Block& b, int j, double* first,
                      Index stride) {
  to.put(b.xx, b.yx, j, first);
  to.put(b.xy, b.yy, j, first + stride);
}
template <class Numbering>
EPAFI_INLINE void put(const Numbering& to, const Scalar& b, int j, double* first,
                      Index /*stride*/) {
  to.put(b.value, j, first);
}
template <class Numbering>
EPAFI_INLINE void putNodes(const Numbering& to, const Block& before, const Block& behind,
                           double* first, Index stride) {
  to.putNodes(before.xx, before.yx, behind.xx, behind.yx, first);
  to.putNodes(before.xy, before.yy, behind.xy, behind.yy, first + stride);
}
template <class Numbering>
EPAFI_INLINE void putNodes(const Numbering& to, const Scalar& before,
                           const Scalar& behind, double* first, Index /*stride*/) {
  to.putNodes(before.value, behind.value, first);
}
EPAFI_INLINE void storeBlock(const Block& b, AlignedLane* to) {
  store(to[0].lane, b.xx);
  store(to[1].lane, b.yx);
  store(to[2].lane, b.xy);
  store(to[3].lane, b.yy);
}
EPAFI_INLINE void storeBlock(const Scalar& b, AlignedLane* to) {
  store(to[0].lane, b.value);
}

/// Is node k of an element on a line an end of its edge?
bool endsEdge(const Mesh& mesh, int e, int k) {
  return mesh.lineOf(e) >= 0 &&
         !mesh.areOnLine(k == 0 ? mesh[e].previous : mesh[e].next, e);
}

}  // namespace

/// What the kernels read and write.
template <class Family>
struct TileBlocks<Family>::Work {
  TileBlocks& to;
  const Tile& m;
  const Element& f;
  AlignedLane wanted = {};  ///< 1 in lanes that are, else 0
  AlignedLane others = {};  ///< the same without f
  AlignedLane bent = {};    ///< 1 in wanted lanes that are not on one line with f, else 0
  bool endsEdge[2] = {};    ///< the first, the last node of f
};

template <class Family>
template <int Degree, int Rows>
class TileBlocks<Family>::Filling {
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
    const double whole = wholeOf(i, j);
    const Pack area = wanted_ * w_.f.half * load(to_.run_->half);
    put(densities_, area * to_.family_.singleLayer(log, phase, whole), j,
        to_.first(to_.single_, i), to_.longest_);
    if (i >= (Rows > 0 ? Rows : w_.f.degree) ||
        j >= (Degree > 0 ? Degree : to_.run_->degree))
      return;
    const Pack scale = wanted_ * to_.functionSlopes_[j < 1 ? 1 : j + 1];
    const auto slopes = scale * to_.family_.slopes(log, phase, whole);
    double* to = to_.first(to_.hypersingular_, i);
    if (i == 0 && j == 0)
      storeBlock(slopes, to_.halfSlopes_);
    if (j == 0)
      putNodes(displacements_, (Pack{} - 1.0) * slopes, slopes, to, to_.longest_);
    else
      put(displacements_, slopes, j, to, to_.longest_);
  }

  // On one line K_Δ vanishes, and the phase is one constant, whose contributions of
  // neighbours cancel at every node but the edge's ends: adding and subtracting it would
  // leave rounding, which is large beside the rest as ν -> 1/2.  `half` of the test's
  // element; `phases`: 1 where the phase counts, else 0.
  // NOLINTNEXTLINE(readability-function-*): of one formula
  EPAFI_INLINE auto doubleBlock(const Pack& half, double slope, const Pack& phases,
                                const Pack& log, const ComplexPack& phase,
                                const Pack& laplace) const {
    const Pack ofLog = slope * log;
    const Pack counted = slope * phases;
    const Pack ofLaplace = bent_ * laplace;
    return half * to_.family_.doubleLayer(ofLog, counted * phase, ofLaplace);
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
      const Pack& phases = k < 2 && w_.endsEdge[k] ? wanted_ : bent_;
      put(densities_,
          doubleBlock(half, to_.functionSlopes_[k], phases, log, phase, laplace), j,
          to_.first(to_.double_, k), to_.longest_);
    }
  }

  // tests P_i on f, sources φ_k on the lanes
  EPAFI_INLINE void putTransposed(int i, int j, const Pack& log,
                                  const ComplexPack& phase) const {
    const Tile::Lane* direct = w_.m.direct + i * Tile::stride;
    const Pack half = load(w_.others.lane) * w_.f.half;
    double* to = to_.first(to_.transposed_, i);
    // with the phase where a node ends its edge
    const Pack line = wanted_ - bent_;
    const Pack before = bent_ + line * load(to_.endsEdge_[0].lane);
    const Pack behind = bent_ + line * load(to_.endsEdge_[1].lane);
    Pack laplace;
    laplaceOf(j + 1, direct, 1, laplace);
    const auto b = mirrored(doubleBlock(half, to_.functionSlopes_[j + 1],
                                        j == 0 ? behind : bent_, log, phase, laplace));
    if (j > 0) {
      put(displacements_, b, j, to, to_.longest_);
      return;
    }
    laplaceOf(0, direct, 1, laplace);
    const auto a =
        mirrored(doubleBlock(half, to_.functionSlopes_[0], before, log, phase, laplace));
    putNodes(displacements_, a, b, to, to_.longest_);
  }

  const Work& w_;
  TileBlocks& to_;
  ColumnNumbering<Degree> densities_;
  ColumnNumbering<Degree> displacements_;
  Pack wanted_;
  Pack bent_;
};

template <class Family>
struct TileBlocks<Family>::Fill {
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

template <class Family>
TileBlocks<Family>::TileBlocks(const Space& space, const Family& family)
    : PairColumns(space), family_(family) {
  assert(space.components() == Family::components);
}

template <class Family>
void TileBlocks<Family>::setRun(const ElementLanes& run, int trial) {
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

template <class Family>
void TileBlocks<Family>::fill() {
  setRun(tile_.run(), tile_.trial());
  const int f = tile_.trial();
  const Mesh& mesh = space_.mesh();
  Work work = {*this, tile_, mesh[f]};
  for (int k = 0; k < 2; ++k)
    work.endsEdge[k] = endsEdge(mesh, f, k);
  for (int lane = 0; lane < lanes; ++lane) {
    const bool isThere = tile_.isWanted(lane);
    const bool isBent = lines_[static_cast<std::size_t>(lane)] != work.f.piece.edge;
    work.wanted.lane[lane] = isThere ? 1 : 0;
    work.others.lane[lane] = isThere && run_->first + lane != f ? 1 : 0;
    work.bent.lane[lane] = isThere && isBent ? 1 : 0;
  }
  dispatch(Fill{work});
  if (tile_.isWanted(f - run_->first))
    addHalf(massOf(mesh[f]));
}

template <class Family>
double TileBlocks<Family>::energy(int lane, const LocalField& onTrial,
                                  const LocalField& onLane) const {
  const Element& x = space_.mesh()[tile_.trial()];
  const Element& y = space_.mesh()[tile_.run().first + lane];
  const Complex tangent = asComplex(y.curve.frame().tangent);
  double sum = 0;
  for (int i = 0; i < x.densities; ++i)
    for (int j = 0; j < y.densities; ++j) {
      const double whole = i == 0 && j == 0 ? 4 : 0;
      const double log = tile_.log[i * Tile::stride + j][lane];
      const Complex phase = tile_.phase(i, j, lane, tangent);
      sum += family_.energy(onTrial.density[at(i)], onLane.density[at(j)], log, phase,
                            whole, false) +
             family_.energy(onTrial.slope[at(i)], onLane.slope[at(j)], log, phase, whole,
                            true);
    }
  return x.half * y.half * sum;
}

template class TileBlocks<KelvinMoments>;
template class TileBlocks<LaplaceMoments>;

}  // namespace epafi::bem
