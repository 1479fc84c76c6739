#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::contact {

using bem::Index;
using bem::Matrix;
using bem::Vector;

/// A fixed point of the slips by which sides wear: s = S(s), S those of the step that is solved with s.
///
///   at first   s takes a share ω of the change S - s, by Aitken's rule for vectors, so that changes that
///              are each a multiple of the one before, of either sign, vanish with the third;
///   then       a step of ds/dτ = S - s, implicit in the derivative of S:  (1/τ + 1 - S') Δs = S - s,  where
///              τ grows as the change falls, towards Newton's step, and falls as it grows.
///
/// S' may be -40 where an element sticks or slips by what it wears, and have imaginary parts of any size:
/// no one share settles what the others need.                        [doc/theory/surfaces.md]
class SlipIteration {
 public:
  /// s >= 0
  const Vector& slips() const { return slips_; }
  /// Shall take() be given S'?
  bool wantsResponse() const;

  /// Moves s by S(s).  `isSolved`: is it that of a solution?  Only what is behind one is damped.
  /// \param response  S'; of size zero: not known
  /// Returns how far s moved over the change.
  double take(const Vector& next, bool isSolved, Matrix response);
  /// The next one is taken as it is.
  void forget() { known_ = false; }

 private:
  /// ω of the change after the last share.
  double shareOf(const Vector& change);
  /// Δs
  Vector implicitStep(const Vector& change, Matrix response);

  Vector slips_{};
  bool known_ = false;     ///< are slips_ those of a solution?
  Vector changeBefore_{};  ///< empty: none
  double share_ = 1;       ///< ω
  double time_ = 0;        ///< τ
  double longest_ = 0;     ///< its bound, which falls where the change grew
  int taken_ = 0;          ///< number of solves
};

}  // namespace epafi::contact
