#include "bem/moments/ElementPotential.hpp"

#include "bem/simd/Dispatch.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

using Need = ElementPotential::Need;

/// With w = (h/2) τ conj(z-t), C_j = ∫ P_j dt/(z-t):
///
///   ∫ P_j ds/conj(w) = τ C_j,          ∫ P_j w/conj(w)² ds = τ³ ∫ P_j (1/(z-t) - 2ib/(z-t)²) dt,
///   ∫ P_j w/conj(w) dt = τ² (2δ_j0 - 2ib C_j)
struct OfSegment {
  const Curve& curve;
  int terms;
  Need need;
  KernelLanes* to;

  template <int Parts>
  EPAFI_INLINE void evaluate(const TargetLanes& x) const;
};

template <int Parts>
EPAFI_INLINE void OfSegment::evaluate(const TargetLanes& x) const {
  const Complex tangent = asComplex(curve.frame().tangent);
  const Complex square = tangent * tangent;
  const double half = curve.half();
  const double logOfHalf = std::log(half);
  const int logs = need == Need::Sums ? 0 : need == Need::Moments ? terms - 1 : terms;
  const bool cubics = need == Need::Sums || need == Need::All;
  LegendreLanes<Parts> legendre;
  legendre.evaluate(x, (Parts == 2 && cubics) || logs == terms ? terms : terms - 1);
  for (int j = 0; j < logs; ++j)
    store(to[j].log.lane, half * legendre.l[j] + (j == 0 ? 2 * half * logOfHalf : 0));
  if (need == Need::Log)
    return;
  if (need == Need::Moments) {
    store(to[logs].log.lane, Pack{});
    to[logs].phase.store({});
  }
  const Pack b = (2 * half) * x.b;
  for (int j = 0; j < terms; ++j) {
    const ComplexPack c = legendre.at(j);
    to[j].overConj.store(tangent * c);
    if (cubics)
      to[j].cubic.store((tangent * square) * legendre.cubic(x, j));
    if (j >= logs)
      continue;
    const ComplexPack phase{(j == 0 ? 2 * half : 0) + b * c.im, -b * c.re};
    to[j].phase.store(need == Need::Moments ? phase : square * phase);
  }
}

struct AtPoints {
  const OfSegment& segment;
  const SeenPoints& points;
  std::size_t k;

  template <Division>
  EPAFI_INLINE void run() const {
    const TargetLanes x = points.at(k);
    if (points.areOnEdge())
      segment.evaluate<1>(x);
    else
      segment.evaluate<2>(x);
  }
};

struct AtPlaces {
  const OfSegment& segment;
  const AlignedLane& x;
  const AlignedLane& y;

  template <Division>
  EPAFI_INLINE void run() const {
    segment.evaluate<2>(TargetLanes(segment.curve, load(x.lane), load(y.lane)));
  }
};

}  // namespace

ElementPotential::ElementPotential(const Curve& curve, int terms, Need need)
    : curve_(curve), terms_(terms), need_(need) {
  if (!curve.isStraight())
    rule_.emplace(curve, terms - 1);
}

void ElementPotential::evaluate(const SeenPoints& points, std::size_t k,
                                InstructionSet set) {
  if (rule_)
    rule_->evaluate(points.at(k), lanes_.data(), set);
  else
    dispatch(set, AtPoints{OfSegment{curve_, terms_, need_, lanes_.data()}, points, k});
}

void ElementPotential::evaluate(const AlignedLane& x, const AlignedLane& y,
                                InstructionSet set) {
  if (!rule_)
    return dispatch(set, AtPlaces{OfSegment{curve_, terms_, need_, lanes_.data()}, x, y});
  RelativeTarget targets[lanes];
  for (int lane = 0; lane < lanes; ++lane)
    targets[lane] = curve_.seen({x.lane[lane], y.lane[lane]});
  rule_->evaluate(TargetLanes(targets), lanes_.data(), set);
}

Complex ElementPotential::share(const LegendreSeries<Complex>& density, int k) const {
  return rule_ ? bem::evaluate(density, terms_ - 1, rule_->point(k))
               : density[static_cast<std::size_t>(k)];
}

}  // namespace epafi::bem
