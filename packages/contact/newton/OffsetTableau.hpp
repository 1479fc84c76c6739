#pragma once

#include "contact/problem/Flexibility.hpp"
#include "contact/problem/Tangential.hpp"

#include <vector>

namespace epafi::contact {

/// A piece of a slip bound, linear in the pressure:  s = constant + slope λ_normal.
struct BoundPiece {
  double constant = 0;
  double slope = 0;
  Index normal = 0;  ///< of the pressure, if slope != 0
};

/// Tableau of principal pivoting: the linear system for one active set, updated by pivots.
///
/// For each coefficient x_i or r_i is zero (nonbasic), the other one is
///
///   basic_i = Σ_j T_ij nonbasic_j + q_i + t v_i,     r = d - D λ,
///   λ_i = x_i (normal, bonded),  λ_i = x_i + side_i s_i (tangential).
///
/// x_i = 0: open, slip; r_i = 0: closed, stick.  A pivot takes 2 n² operations.
class OffsetTableau {
 public:
  /// x = 0, s = 0, v = 0.  \param flexibility D  \param offset d
  OffsetTableau(Index normals, const Matrix& flexibility, const Vector& offset);

  Index size() const { return size_; }
  bool isActive(Index i) const { return active_[at(i)]; }  ///< r_i = 0
  bool isNormal(Index i) const { return i < normals_; }
  double side(Index i) const { return side_[at(i)]; }
  const BoundPiece& piece(Index i) const { return pieces_[at(i)]; }

  /// q_i + t v_i, the basic variable of i.
  double value(Index i, double t) const { return T_(i, size_) + t * rate(i); }
  double rate(Index i) const { return T_(i, size_ + 1); }
  void setRate(Index i, double v) { T_(i, size_ + 1) = v; }
  /// λ_i of a normal coefficient.
  double pressure(Index i, double t) const { return isActive(i) ? value(i, t) : 0; }
  double bound(Index i, double t) const { return valueOf(piece(i), t); }
  double boundRate(Index i) const;
  /// s by another piece minus s_i.
  double gain(Index i, const BoundPiece& other, double t) const {
    return valueOf(other, t) - bound(i, t);
  }
  double multiplier(Index i, double t) const;

  /// Exchanges x_i and r_i.
  void pivot(Index i);
  /// Changes side and piece of i.  Returns 1, or, if r_i is basic, the factor 1 -
  /// ∂s/∂x_i, negative where t changes its direction.
  double setPiece(Index i, double side, const BoundPiece& piece);

 private:
  double valueOf(const BoundPiece& piece, double t) const;

  Index size_;
  Index normals_;
  Matrix T_;  // [T, q, v]
  std::vector<bool> active_;
  Vector side_;
  std::vector<BoundPiece> pieces_;
};

}  // namespace epafi::contact
