#pragma once

namespace epafi::bem {

struct EndValues {
  double start;  ///< e(-t)
  double end;    ///< e(t)
};

/// The polynomial of degree p that stands for the value at t = 1 of polynomials v of that
/// degree:
///
///   e(t) = Σ_k (k + 1/2) P_k(t),  k = 0 ... p,   ∫ e v dt = v(1);  e(-t) has v(-1).
EndValues endValues(int degree, double t);

}  // namespace epafi::bem
