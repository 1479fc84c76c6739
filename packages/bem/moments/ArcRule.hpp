#pragma once

#include "bem/moments/LegendreLanes.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// Largest angle [rad] by which an element may turn.
constexpr double largestAngle = 3.1415926535897932 * (1 + 1e-12);

/// Kernel integrals of a density g at eight targets x, w = x - y.  For a function g of t the
/// integrals are over t instead of s.
struct KernelLanes {
  ComplexLanes overConj;  ///< ∫ g ds/conj(w); conjugate of ∫ g ds/w if g is real
  ComplexLanes cubic;     ///< ∫ g w/conj(w)² ds
  ComplexLanes phase;     ///< ∫ g w/conj(w) ds
  AlignedLane log;        ///< ∫ g log|w| ds
};

/// Gauss rule on an arc for kernels times polynomials.  With x - y(t) = (t₀ - t) g(t) and as
/// many terms as points, Legendre series represent P_j/g and P_j g/conj(g)², j <= degree, to
/// 1e-15.
///                                                     [doc/theory/operators.md]
class ArcRule {
 public:
  static constexpr int largestSize = 63;

  /// \throws InputError if the arc turns by more than largestAngle
  ArcRule(const Curve& curve, int degree);

  const Curve& curve() const { return curve_; }
  int degree() const { return degree_; }
  int size() const { return rule_->size(); }
  double point(int q) const { return rule_->points[static_cast<std::size_t>(q)]; }
  double weight(int q) const { return rule_->weights[static_cast<std::size_t>(q)]; }
  /// P_j at point q, j <= degree.
  double legendre(int q, int j) const { return legendre_[at(q, j)]; }
  Complex tangent(int q) const { return tangents_[static_cast<std::size_t>(q)]; }
  Complex normal(int q) const { return {tangent(q).imag(), -tangent(q).real()}; }

  /// Weights of the kernels at eight targets: for real polynomials f of the degree
  /// ∫ f ds/conj(w) = Σ f_q overConj_q and so on; principal values on the arc.  Accurate up to the
  /// arc, since 1/(t₀-t) and similar factors are integrated against Legendre polynomials in closed
  /// form (LegendreLanes).
  void evaluate(const TargetLanes& x, KernelLanes* weights) const;

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

}  // namespace epafi::bem
