#pragma once

#include "contact/problem/Flexibility.hpp"
#include "contact/problem/Tangential.hpp"

#include <vector>

namespace epafi::contact {

/// A piece of a slip bound, linear in the pressure:  s = constant + slope λ_normal.
struct BoundPiece {
  double constant = 0;
  double slope = 0;
  Index normal = 0;  ///< where there is a slope
};

/// The linear system of a choice of sets, its inverse kept from one choice to the next.
///
/// Of a coefficient either x_i or r_i is zero, and the other one is
///
///   basic_i = Σ_j T_ij zero_j + q_i + t v_i,     r = d - D λ,
///   λ_i = x_i (normal ones, bonded ones),  λ_i = x_i + side_i s_i (all others).
///
/// x_i = 0: open, slipping; r_i = 0: closed, sticking.  A change takes 2 n² operations.
class OffsetTableau {
 public:
  /// All x = 0, no bounds, v = 0.  \param flexibility D  \param offset d
  OffsetTableau(Index normals, const Matrix& flexibility, const Vector& offset);

  Index size() const { return size_; }
  bool isActive(Index i) const { return active_[at(i)]; }  ///< r_i = 0
  bool isNormal(Index i) const { return i < normals_; }
  double side(Index i) const { return side_[at(i)]; }
  const BoundPiece& piece(Index i) const { return pieces_[at(i)]; }

  double value(Index i, double t) const { return T_(i, size_) + t * rate(i); }
  double rate(Index i) const { return T_(i, size_ + 1); }
  void setRate(Index i, double v) { T_(i, size_ + 1) = v; }
  /// Of a normal coefficient: pressure, zero where it is open.
  double pressure(Index i, double t) const { return isActive(i) ? value(i, t) : 0; }
  double bound(Index i, double t) const { return valueOf(piece(i), t); }
  double boundRate(Index i) const;
  /// What another piece has more.
  double gain(Index i, const BoundPiece& other, double t) const {
    return valueOf(other, t) - bound(i, t);
  }
  double multiplier(Index i, double t) const;

  /// x_i and r_i change places.
  void pivot(Index i);
  /// λ_i = x_i + side s with another side and piece.  Where r_i is basic, the sign of what it
  /// multiplies changes of the bound by: negative where t turns back.
  double setPiece(Index i, double side, const BoundPiece& piece);

 private:
  double valueOf(const BoundPiece& piece, double t) const;

  Index size_;
  Index normals_;
  Matrix T_;  // and q, v
  std::vector<bool> active_;
  Vector side_;
  std::vector<BoundPiece> pieces_;
};

}  // namespace epafi::contact
