#include "bem/moments/RingTile.hpp"

#include "bem/moments/RingRules.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

constexpr int count = RingKernels::count;

/// Gauss points for a kernel times so many Legendre polynomials and the radius.
int gaussPoints(int smoothOrder, int polynomials) {
  return smoothOrder + (polynomials + 1) / 2;
}

/// An element at eight parameters.
class Eight {
 public:
  EPAFI_INLINE explicit Eight(const Element& element)
      : half_(element.half),
        radius_(element.curve.frame().middle.x),
        tangent_(asComplex(element.curve.frame().tangent)),
        alpha_(0.5 * element.curve.angle()) {}

  EPAFI_INLINE void at(const Pack& t, Pack& radius, ComplexPack& tangent) const {
    if (alpha_ == 0) {
      radius = radius_ + half_ * tangent_.real() * t;
      tangent = {Pack{} + tangent_.real(), Pack{} + tangent_.imag()};
      return;
    }
    const Pack angle = (0.5 * alpha_) * t;
    Pack sinc;
    Pack cosine;
    sineCosine(angle, sinc, cosine);
    const ComplexPack turn{cosine, angle * sinc};
    const ComplexPack chord = tangent_ * turn;
    radius = radius_ + half_ * t * sinc * chord.re;
    tangent = turn * chord;
  }

 private:
  double half_;
  double radius_;
  Complex tangent_;
  double alpha_;
};

}  // namespace

/// Pairs of an element with far ones: tensor rules, inner integrals first.
struct FarRings {
  RingTile& to;
  const Element& e;
  const ElementLanes& far;
  const AlignedLane& radii;  ///< of the middles of far elements
  const Rule& outer = gaussLegendre(gaussPoints(far.smooth.outer, to.rows_));
  const Rule& inner = gaussLegendre(gaussPoints(far.smooth.inner, to.columns_));

  template <Division How>
  EPAFI_INLINE void run() const {
    if (to.columns_ == 2)
      sum<How, 2>();
    else
      sum<How, 0>();
  }

 private:
  template <Division How, int Columns>
  EPAFI_INLINE void sum() const {
    const int columns = Columns > 0 ? Columns : to.columns_;
    const WeightedLegendre& outerTable = weightedLegendre(outer.size());
    const WeightedLegendre& innerTable = weightedLegendre(inner.size());
    ElementLanes::Points points[largestGaussOrder];
    Pack radius[largestGaussOrder];
    for (int p = 0; p < inner.size(); ++p) {
      points[p] = far.at(Pack{} + inner.points[p]);
      radius[p] = load(radii.lane) + points[p].place.re;
    }
    constexpr int size = Columns > 0 ? Columns : largestMoment + 1;
    Pack sums[count][size];
    for (int q = 0; q < outer.size(); ++q) {
      const double t = outer.points[q];
      const Vec2 offset = e.curve.fromMiddle(t);
      const Vec2 tangent = e.curve.tangent(t);
      const Pack zero{};
      RingPair at;
      at.x = zero + (e.curve.frame().middle.x + offset.x);
      at.tangentX = {zero + tangent.x, zero + tangent.y};
      const ComplexPack middle{load(far.wx) + offset.x, load(far.wy) + offset.y};
      for (int k = 0; k < count; ++k)
        for (int j = 0; j < columns; ++j)
          sums[k][j] = Pack{};
      for (int p = 0; p < inner.size(); ++p) {
        at.y = radius[p];
        at.w = middle - points[p].place;
        at.tangentY = points[p].tangent;
        RingKernels kernels;
        ringKernels<How>(to.lame_, at, kernels);
        const double* weights = innerTable[p].data();
        for (int k = 0; k < count; ++k)
          for (int j = 0; j < columns; ++j)
            sums[k][j] += kernels.of[k] * weights[j];
      }
      const double* weights = outerTable[q].data();
      for (int k = 0; k < count; ++k)
        for (int i = 0; i < to.rows_; ++i)
          for (int j = 0; j < columns; ++j)
            bem::add(to.moments_[to.position(k, i, j)].lane, sums[k][j] * weights[i]);
    }
  }
};

/// One pair by points in packs; a lane of the sums has what its points give.
struct NearRings {
  RingTile& to;
  const Element& x;
  const Element& y;
  const std::vector<RingPoints>& points;

  template <Division How>
  EPAFI_INLINE void run() const {
    const Eight onE(x);
    const Eight onF(y);
    Pack onX[largestMoment + 1];
    Pack onY[largestMoment + 1];
    for (const RingPoints& p : points) {
      RingPair at;
      RingKernels kernels;
      onE.at(load(p.t.lane), at.x, at.tangentX);
      onF.at(load(p.s.lane), at.y, at.tangentY);
      at.w = p.w.load();
      ringKernels<How>(to.lame_, at, kernels);
      legendre(load(p.t.lane), load(p.weight.lane), to.rows_, onX);
      legendre(load(p.s.lane), Pack{} + 1.0, to.columns_, onY);
      for (int k = 0; k < count; ++k)
        for (int i = 0; i < to.rows_; ++i) {
          const Pack value = kernels.of[k] * onX[i];
          for (int j = 0; j < to.columns_; ++j)
            bem::add(to.sums_[to.position(k, i, j)].lane, value * onY[j]);
        }
    }
  }

 private:
  EPAFI_INLINE static void legendre(const Pack& t, const Pack& scale, int size,
                                    Pack* values) {
    values[0] = scale;
    values[1] = t * scale;
    for (int i = 1; i + 1 < size; ++i)
      values[i + 1] =
          ((2 * i + 1.0) / (i + 1)) * (t * values[i]) - (i / (i + 1.0)) * values[i - 1];
  }
};

void RingTile::evaluate(const ElementRuns& runs, int trial, int r,
                        const ElementRange& wanted) {
  trial_ = trial;
  run_ = &runs[r];
  wanted_ = {std::max(wanted.first, run_->first), std::min(wanted.last, run_->last)};
  const Mesh& mesh = runs.mesh();
  for (int lane = 0; lane < lanes; ++lane) {
    const int f = run_->first + lane;
    onAxis_[lane] = f < run_->last && mesh.isAxis(f);
  }
  rows_ = mesh[trial].densities + 1;
  columns_ = columnsOf(*run_);
  moments_.assign(static_cast<std::size_t>(count * rows_ * columns_), {});
  const ElementLanes chosen = runs.choose(trial, r, wanted_);
  if (chosen.smooth.isFar())
    far(mesh, chosen);
  for (int e = wanted_.first; e < wanted_.last; ++e)
    if (const int lane = e - run_->first; !chosen.far[lane] && !onAxis_[lane])
      near(mesh, e, lane);
}

void RingTile::far(const Mesh& mesh, const ElementLanes& chosen) {
  constexpr double harmless = 3;  // a radius of unused lanes, see ElementLanes::drop
  AlignedLane radii;
  for (int lane = 0; lane < lanes; ++lane)
    radii.lane[lane] =
        chosen.far[lane] ? mesh[run_->first + lane].curve.frame().middle.x : harmless;
  dispatch(FarRings{*this, mesh[trial_], chosen, radii});
}

void RingTile::near(const Mesh& mesh, int e, int lane) {
  static thread_local std::vector<RingPoints> points;
  nearRingPoints(mesh, trial_, e, more_, points);
  sums_.assign(moments_.size(), {});
  dispatch(NearRings{*this, mesh[trial_], mesh[e], points});
  for (std::size_t k = 0; k < moments_.size(); ++k) {
    const double* x = sums_[k].lane;
    moments_[k].lane[lane] =
        ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
  }
}

}  // namespace epafi::bem
