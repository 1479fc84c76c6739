#pragma once

#include "bem/base/Material.hpp"
#include "bem/moments/ElementRuns.hpp"

#include <array>
#include <vector>

namespace epafi::bem {

/// ∫ W v · P̂_i e_a ds and ∫ K' f · P̂_i e_a ds on one element E for sources on elements
/// far from it: f = P_j e_c, and v with the derivative P_j e_c / h by arc length, h the
/// source's length.  P̂_i are the orthonormal Legendre polynomials on E.
///
/// Tensor Gauss with one reciprocal and no logarithm a point pair: W and K' at a point
/// are, see kernel/Elasticity, linear in
///
///   ∫ P_j ds/conj(w)      = a τ ∫ P_j v/r² dt,         w = x - y = τ v,  v = η - i off,
///   ∫ P_j w/conj(w)² ds   = a τ³ ∫ P_j v³/r⁴ dt,       a half the source's length,
///
/// and off does not depend on t.  On arcs both integrands are taken at each pair of points.
class FarTractions {
 public:
  enum class Operator { Adjoint, Hypersingular };

  /// For i < moments <= largestDegree + 1.
  FarTractions(const Element& e, const Lame& lame, int moments);

  int moments() const { return moments_; }

  /// Treats a batch that ElementRuns chose, j < chosen.columns; lanes of lower degree
  /// than that hold nothing of use beyond it.
  void evaluate(const FarBatch& batch, const FarLanes& chosen,
                InstructionSet set = largestInstructionSet());

  /// The same for one source where it or E is an arc, into a lane; `w` as in FarBatch.
  void evaluateArc(const Element& source, Vec2 w, FarOrder smooth, int lane);

  /// Gauss points on E that this takes.
  static int outerPoints(const FarLanes& chosen, int moments) {
    return chosen.smooth.outer + polynomialShare(moments - 1);
  }

  /// Both components c of every lane in turn: [2 * lane + c].
  const double* at(Operator op, int i, int j, int a) const {
    return values_.data() + place(op, i, j, a);
  }

 private:
  // Gauss points for polynomials of a degree beside a kernel; half of it is not enough
  // from degree 10 on.
  static constexpr int polynomialShare(int degree) { return (degree + 2) / 2; }

  static constexpr std::size_t block = 2 * lanes;
  std::size_t place(Operator op, int i, int j, int a) const {
    const int k = op == Operator::Adjoint ? 0 : 1;
    return static_cast<std::size_t>(((i * largestDegree + j) * 2 + k) * 2 + a) * block;
  }

  Element element_;
  Lame lame_;
  int moments_;
  /// [i][kind][c][a][part of the two integrals]
  std::vector<std::array<double, 32>> map_;
  std::vector<double> values_;
};

}  // namespace epafi::bem
