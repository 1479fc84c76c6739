#pragma once

#include "bem/moments/ArcRule.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <optional>

namespace epafi::bem {

/// Kernel integrals over an element at eight targets, in closed form.  Carriers g represent the
/// densities: on a segment the Legendre polynomials P_0, P_1, ..., on an arc its Gauss points
/// (ArcRule).                                               [doc/theory/operators.md]
class ElementPotential {
 public:
  /// Which integrals: overConj and cubic; overConj, phase and log; log alone; all.  Moments: log and
  /// phase of the last polynomial are left out, and phases of polynomials are divided by τ², τ the
  /// tangent at the middle.
  enum class Need { Sums, Moments, Log, All };

  /// \param terms number of Legendre polynomials of the densities, at most 26
  /// Refers to the curve.
  ElementPotential(const Curve& curve, int terms, Need need = Need::Sums);

  /// \param targets relative to the curve, see seenFrom
  void evaluate(const TargetLanes& targets, InstructionSet set = largestInstructionSet());
  /// At points with these coordinates, not on the element.
  void evaluate(const AlignedLane& x, const AlignedLane& y);

  int size() const { return rule_ ? rule_->size() : terms_; }
  const KernelLanes& operator[](int k) const {
    return lanes_[static_cast<std::size_t>(k)];
  }

  /// Coefficient of carrier k in a density.
  Complex share(const LegendreSeries<Complex>& density, int k) const;
  /// Unit normal at carrier k.
  Complex normal(int k) const {
    return rule_ ? rule_->normal(k) : asComplex(curve_.frame().normal);
  }
  /// ∫ g ds
  double whole(int k) const {
    return curve_.half() * (rule_ ? rule_->weight(k) : k == 0 ? 2 : 0);
  }

  /// Kernel integrals of P_j, those that are needed.
  struct alignas(64) Values {
    ComplexPack overConj;
    ComplexPack cubic;
    ComplexPack phase;
    Pack log{};
    Pack flow{};  ///< ∫ P_j (w·n_y)/|w|² ds, with log
  };
  EPAFI_INLINE Values of(int j) const {
    if (!rule_)
      return ofCarrier(j);
    Values sum{};
    for (int k = 0; k < size(); ++k) {
      const double share = rule_->legendre(k, j);
      const Values own = ofCarrier(k);
      sum.overConj = sum.overConj + share * own.overConj;
      sum.cubic = sum.cubic + share * own.cubic;
      sum.phase = sum.phase + share * own.phase;
      sum.log += share * own.log;
      sum.flow += share * own.flow;
    }
    const Complex tangent = asComplex(curve_.frame().tangent);
    if (need_ == Need::Moments)
      sum.phase = std::conj(tangent * tangent) * sum.phase;
    return sum;
  }

 private:
  EPAFI_INLINE Values ofCarrier(int k) const {
    const KernelLanes& own = (*this)[k];
    Values values{};
    if (need_ != Need::Sums)
      values.log = load(own.log.lane);
    if (need_ == Need::Log)
      return values;
    values.overConj = own.overConj.load();
    if (need_ != Need::Moments)
      values.cubic = own.cubic.load();
    if (need_ == Need::Sums)
      return values;
    values.phase = own.phase.load();
    const Complex n = normal(k);
    values.flow = n.real() * values.overConj.re + n.imag() * values.overConj.im;
    return values;
  }

  const Curve& curve_;
  int terms_;
  Need need_;
  std::optional<ArcRule> rule_;
  std::array<KernelLanes, ArcRule::largestSize> lanes_;
};

}  // namespace epafi::bem
