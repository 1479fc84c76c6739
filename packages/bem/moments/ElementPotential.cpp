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
  LegendreLanes<Parts> legendre;
  legendre.evaluate(x, Parts == 1 && need == Need::Sums ? terms - 1 : terms);
  for (int j = 0; j < terms; ++j) {
    const ComplexPack c = legendre.at(j);
    to[j].overConj.store(tangent * c);
    if (need != Need::Moments)
      to[j].cubic.store((tangent * square) * legendre.cubic(x, j));
    if (need == Need::Sums)
      continue;
    const double half = curve.half();
    const double whole = j == 0 ? 2 * half : 0;
    const Pack b = (2 * half) * x.b;
    to[j].phase.store(square * ComplexPack{whole + b * c.im, -b * c.re});
    store(to[j].log.lane, half * legendre.l[j] + whole * std::log(half));
  }
}

struct AtTargets {
  const OfSegment& segment;
  const TargetLanes& x;

  template <Division>
  EPAFI_INLINE void run() const {
    if (x.isOnEdge)
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

void ElementPotential::evaluate(const TargetLanes& x, InstructionSet set) {
  if (rule_)
    rule_->evaluate(x, lanes_.data(), set);
  else
    dispatch(set, AtTargets{OfSegment{curve_, terms_, need_, lanes_.data()}, x});
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
