#pragma once

#include "bem/geometry/Curve.hpp"
#include "bem/quadrature/Gauss.hpp"

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

/// Which weights are wanted.
enum class ArcNeed { Potentials, Sums, All };

/// The kernels at a target x as weights of an arc's points: for polynomials f of the rule's
/// degree, w = x - y(t), on the arc as principal values,
///
///   ∫ f log|w| dt = Σ f_q log_q            ∫ f dt/w               = Σ f_q overW_q
///   ∫ f w/conj(w) dt = Σ f_q phase_q       ∫ conj(f) w/conj(w)² dt = Σ conj(f_q) cubic_q
///
/// accurate right up to the arc: 1/(t₀-t) and its like are integrated against Legendre
/// polynomials in closed form (LegendreMoments).  At an end of the arc log and phase have
/// limits, the others none.
struct ArcWeights {
  std::array<double, ArcRule::largestSize> log{};
  std::array<Complex, ArcRule::largestSize> phase{};
  std::array<Complex, ArcRule::largestSize> overW{};
  std::array<Complex, ArcRule::largestSize> cubic{};

  /// Potentials: log, phase and overW; Sums: overW and cubic.
  void evaluate(const ArcRule& rule, const RelativeTarget& x, ArcNeed need);
};

}  // namespace epafi::bem
