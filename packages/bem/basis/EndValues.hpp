#pragma once

namespace epafi::bem {

struct EndValues {
  double start;  ///< e(-t)
  double end;    ///< e(t)
};

/// The polynomial e of degree p that represents the point value at t = 1 in L²:
///
///   e(t) = Σ_k (k + 1/2) P_k(t),  k = 0 ... p,   ∫ e v dt = v(1),  ∫ e(-t) v dt = v(-1)
/// for all polynomials v of degree p.
EndValues endValues(int degree, double t);

}  // namespace epafi::bem
