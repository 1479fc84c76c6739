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
///
/// Parts 1: all targets are on the line of the segment.
template <int Parts>
struct OfSegment {
  const Curve& curve;
  int terms;
  Need need;
  const TargetLanes& x;
  KernelLanes* to;

  template <Division>
  EPAFI_INLINE void run() const;
};

template <int Parts>
template <Division>
EPAFI_INLINE void OfSegment<Parts>::run() const {
  const Complex tangent = asComplex(curve.frame().tangent);
  const Complex square = tangent * tangent;
  const double half = curve.half();
  const double logOfHalf = std::log(half);
  const int logs = need == Need::Sums ? 0 : need == Need::Moments ? terms - 1 : terms;
  const bool cubics = need == Need::Sums || need == Need::All;
  LegendreLanes<Parts> legendre;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  legendre.evaluate(x, (Parts == 2 && cubics) || logs == terms ? terms : terms - 1);
  for (int j = 0; j < logs; ++j)
    store(to[j].log.lane, half * legendre.l[j] + (j == 0 ? 2 * half * logOfHalf : 0));
  if (need == Need::Log)
    return;
  if (need == Need::Moments) {
    store(to[logs].log.lane, Pack{});
    to[logs].phase.store({});
  }
  const Pack b = (2 * half) * x.z.im;
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

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): evaluate() sets what is used
ElementPotential::ElementPotential(const Curve& curve, int terms, Need need)
    : curve_(curve), terms_(terms), need_(need) {
  if (!curve.isStraight())
    rule_.emplace(curve, terms - 1);
}

void ElementPotential::evaluate(const TargetLanes& targets) {
  if (rule_)
    rule_->evaluate(targets, lanes_.data());
  else if (areOnLine(targets))
    dispatch(OfSegment<1>{curve_, terms_, need_, targets, lanes_.data()});
  else
    dispatch(OfSegment<2>{curve_, terms_, need_, targets, lanes_.data()});
}

void ElementPotential::evaluate(const AlignedLane& x, const AlignedLane& y) {
  if (!rule_)
    return evaluate(seenFrom(curve_, x, y));
  RelativeTarget targets[lanes];
  for (int lane = 0; lane < lanes; ++lane)
    targets[lane] = curve_.seen({x.lane[lane], y.lane[lane]});
  evaluate(packed(targets));
}

Complex ElementPotential::share(const LegendreSeries<Complex>& density, int k) const {
  return rule_ ? bem::evaluate(density, terms_ - 1, rule_->point(k))
               : density[static_cast<std::size_t>(k)];
}

}  // namespace epafi::bem
