#pragma once

#include "bem/moments/ArcWeights.hpp"
#include "bem/moments/LegendreLanes.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <optional>

namespace epafi::bem {

/// The potential of an element at eight targets at once, in closed form.  It acts through
/// carriers g of its densities: on a segment the functions P_0, P_1, ... of its parameter, on an
/// arc Gauss points (ArcRule).                              [doc/theory/operators.md]
class ElementPotential {
 public:
  enum class Need { Sums, All };

  /// Of densities with so many Legendre functions, 26 at most; Sums: without phase and log.
  /// Refers to the curve.
  ElementPotential(const Curve& curve, int terms, Need need = Need::Sums);

  /// At points[first] and those behind it.
  void evaluate(const SeenPoints& points, std::size_t first,
                InstructionSet set = largestInstructionSet());
  /// At points off the element that are given by their coordinates.
  void evaluate(const AlignedLane& x, const AlignedLane& y,
                InstructionSet set = largestInstructionSet());

  int size() const { return rule_ ? rule_->size() : terms_; }
  const KernelLanes& operator[](int k) const {
    return lanes_[static_cast<std::size_t>(k)];
  }

  /// What a carrier has of a density.
  Complex share(const LegendreSeries<Complex>& density, int k) const;
  /// Where a carrier is.
  Complex normal(int k) const {
    return rule_ ? rule_->normal(k) : asComplex(curve_.frame().normal);
  }
  /// ∫ g ds
  double whole(int k) const {
    return curve_.half() * (rule_ ? rule_->weight(k) : k == 0 ? 2 : 0);
  }
  /// What P_j gives at a target.
  struct Values {
    Complex overConj;
    Complex cubic;
    Complex phase;
    double log = 0;
    double flow = 0;  ///< ∫ P_j (w·n_y)/|w|² ds
  };
  Values at(int j, std::size_t lane) const;
  /// The first two at all targets.
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
