#pragma once

#include "bem/moments/LegendreLanes.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/ComplexPack.hpp"
#include "bem/simd/InstructionSet.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// Gauss points of an arc, enough for what kernels make of a polynomial on it: with
/// x - y(t) = (t₀ - t) g(t) the functions P_j/g and P_j g/conj(g)², j <= degree, are met to
/// 1e-15 by Legendre series with as many terms as there are points.
///                                                     [doc/theory/operators.md]
class ArcRule {
 public:
  static constexpr int largestSize = 63;

  /// \throws InputError if the arc turns by more than largestAngle.
  ArcRule(const Curve& curve, int degree);

  const Curve& curve() const { return curve_; }
  int degree() const { return degree_; }
  int size() const { return rule_->size(); }
  double point(int q) const { return rule_->points[static_cast<std::size_t>(q)]; }
  double weight(int q) const { return rule_->weights[static_cast<std::size_t>(q)]; }
  /// P_j there, j <= degree.
  double legendre(int q, int j) const { return legendre_[at(q, j)]; }
  Complex tangent(int q) const { return tangents_[static_cast<std::size_t>(q)]; }
  Complex normal(int q) const { return {tangent(q).imag(), -tangent(q).real()}; }

 private:
  std::size_t at(int q, int j) const {
    return static_cast<std::size_t>(q * (degree_ + 1) + j);
  }
  Curve curve_;
  int degree_;
  const Rule* rule_;
  std::vector<double> legendre_;
  std::vector<Complex> tangents_;
};

/// By how much an element may turn.
constexpr double largestAngle = 3.1415926535897932 * (1 + 1e-12);

/// What a density g has of the kernels at eight targets x, w = x - y.  Without ds where g is a
/// function of t.
struct KernelLanes {
  ComplexLanes
      overConj;  ///< ∫ g ds/conj(w); that of 1/w is its conjugate, where g is real
  ComplexLanes cubic;  ///< ∫ g w/conj(w)² ds
  ComplexLanes phase;  ///< ∫ g w/conj(w) ds
  AlignedLane log;     ///< ∫ g log|w| ds
};

/// The kernels at eight targets as weights of an arc's points: for real polynomials f of the
/// rule's degree ∫ f ds/conj(w) = Σ f_q overConj_q and so on, on the arc as principal values,
/// accurate right up to the arc: 1/(t₀-t) and its like are integrated against Legendre
/// polynomials in closed form (LegendreLanes).
void arcWeights(const ArcRule& rule, const RelativeTarget (&targets)[lanes],
                KernelLanes* weights, InstructionSet set = largestInstructionSet());

}  // namespace epafi::bem
