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
  /// Which integrals: overConj and cubic; overConj, phase and log; log alone; all.  Moments: log of
  /// the last polynomial is left out.
  enum class Need { Sums, Moments, Log, All };

  /// \param terms number of Legendre polynomials of the densities, at most 26
  /// Refers to the curve.
  ElementPotential(const Curve& curve, int terms, Need need = Need::Sums);

  void evaluate(const SeenPoints& points, std::size_t k,
                InstructionSet set = largestInstructionSet());
  /// At points with these coordinates, not on the element.
  void evaluate(const AlignedLane& x, const AlignedLane& y,
                InstructionSet set = largestInstructionSet());

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
    Values sum;
    for (int k = rule_ ? 0 : j; k < (rule_ ? size() : j + 1); ++k) {
      const KernelLanes& own = (*this)[k];
      const double share = rule_ ? rule_->legendre(k, j) : 1;
      if (need_ != Need::Sums)
        sum.log += share * load(own.log.lane);
      if (need_ == Need::Log)
        continue;
      const ComplexPack overConj = share * own.overConj.load();
      sum.overConj = sum.overConj + overConj;
      if (need_ != Need::Moments)
        sum.cubic = sum.cubic + share * own.cubic.load();
      if (need_ == Need::Sums)
        continue;
      const Complex n = normal(k);
      sum.phase = sum.phase + share * own.phase.load();
      sum.flow += n.real() * overConj.re + n.imag() * overConj.im;
    }
    return sum;
  }

 private:
  const Curve& curve_;
  int terms_;
  Need need_;
  std::optional<ArcRule> rule_;
  std::array<KernelLanes, ArcRule::largestSize> lanes_;
};

}  // namespace epafi::bem
