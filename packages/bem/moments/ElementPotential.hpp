#pragma once

#include "bem/moments/ArcRule.hpp"
#include "bem/quadrature/LegendreSeries.hpp"

#include <optional>

namespace epafi::bem {

/// Kernel integrals over an element at eight targets, in closed form.  The densities are
/// combinations of carriers g: on a segment the Legendre polynomials P_0, P_1, ..., on an arc its
/// Gauss points (ArcRule).                                  [doc/theory/operators.md]
class ElementPotential {
 public:
  /// Which integrals to compute.
  enum class Need {
    Sums,  ///< overConj and cubic
    /// overConj; log and phase, but not of the last polynomial.  The phase of a polynomial is
    /// divided by τ², τ: tangent at the midpoint.
    Moments,
    Log,  ///< log only
    All
  };

  /// Refers to the curve.
  /// \param terms number of Legendre polynomials of the densities, at most 26
  ElementPotential(const Curve& curve, int terms, Need need = Need::Sums);

  /// \param targets relative to the curve, as from seenFrom
  void evaluate(const TargetLanes& targets);
  /// At targets with these coordinates, not on the element.
  void evaluate(const AlignedLane& x, const AlignedLane& y);

  /// Number of carriers.
  int size() const { return rule_ ? rule_->size() : terms_; }
  /// Integrals of carrier k.
  const KernelLanes& operator[](int k) const {
    return lanes_[static_cast<std::size_t>(k)];
  }

  /// Coefficient of carrier k in a density.
  Complex share(const LegendreSeries<Complex>& density, int k) const;
  /// Unit normal at carrier k.
  Complex normal(int k) const {
    return rule_ ? rule_->normal(k) : asComplex(curve_.frame().normal);
  }
  /// ∫ g ds of carrier k
  double whole(int k) const {
    return curve_.half() * (rule_ ? rule_->weight(k) : k == 0 ? 2 : 0);
  }

  /// Kernel integrals of P_j, as far as Need includes them.
  struct alignas(64) Values {
    ComplexPack overConj;
    ComplexPack cubic;
    ComplexPack phase;
    Pack log{};
    Pack flow{};  ///< ∫ P_j (w·n_y)/|w|² ds, for Moments and All
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
