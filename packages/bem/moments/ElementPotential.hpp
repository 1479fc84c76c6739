#pragma once

#include "bem/moments/ArcWeights.hpp"
#include "bem/moments/LegendreLanes.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <optional>

namespace epafi::bem {

/// Kernel integrals over an element at eight targets, in closed form.  Carriers g represent the
/// densities: on a segment the Legendre polynomials P_0, P_1, ..., on an arc its Gauss points
/// (ArcRule).                                               [doc/theory/operators.md]
class ElementPotential {
 public:
  enum class Need { Sums, All };

  /// \param terms number of Legendre polynomials of the densities, at most 26
  /// \param need Sums: without phase and log.  Refers to the curve.
  ElementPotential(const Curve& curve, int terms, Need need = Need::Sums);

  /// At points[first] ... points[first + 7].
  void evaluate(const SeenPoints& points, std::size_t first,
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
  /// Kernel integrals of P_j at a target.
  struct Values {
    Complex overConj;
    Complex cubic;
    Complex phase;
    double log = 0;
    double flow = 0;  ///< ∫ P_j (w·n_y)/|w|² ds
  };
  Values at(int j, std::size_t lane) const;
  /// Adds overConj and cubic of P_j at all targets.
  EPAFI_INLINE void add(int j, ComplexPack& overConj, ComplexPack& cubic) const {
    for (int k = rule_ ? 0 : j; k < (rule_ ? size() : j + 1); ++k) {
      const double share = rule_ ? rule_->legendre(k, j) : 1;
      overConj = overConj + share * (*this)[k].overConj.load();
      cubic = cubic + share * (*this)[k].cubic.load();
    }
  }

 private:
  const Curve& curve_;
  int terms_;
  Need need_;
  std::optional<ArcRule> rule_;
  std::array<KernelLanes, ArcRule::largestSize> lanes_;
};

}  // namespace epafi::bem
