#pragma once

#include "bem/basis/Legendre.hpp"

#include <array>
#include <complex>

namespace epafi::reference {

/// All that V, K and W need of a pair of elements E and F: double integrals of Legendre
/// polynomials, w = x - y, x on E, y on F, both mapped to [-1, 1].
///
///   log(i,j)     = ∫∫ P_i(x) P_j(y) log|w|                   i < p_E, j < p_F
///   phase(i,j)   = ∫∫ P_i(x) P_j(y) w/conj(w)                i < p_E, j < p_F
///   direct(i,j)  = ∫∫ P_i(x) P_j(y) (w·n_F)/|w|² h_F/2       i < p_E, j <= p_F
///   reverse(i,j) = ∫∫ P_i(x) P_j(y) (-w·n_E)/|w|² h_E/2      i <= p_E, j < p_F
///
/// log and phase are the same for (F, E) transposed; reverse is the other pair's direct.
class LaneMoments {
 public:
  static constexpr int stride = bem::largestDegree + 2;

  double& log(int i, int j) { return log_[at(i, j)]; }
  double& phaseReal(int i, int j) { return phaseReal_[at(i, j)]; }
  double& phaseImag(int i, int j) { return phaseImag_[at(i, j)]; }
  double& direct(int i, int j) { return direct_[at(i, j)]; }
  double& reverse(int i, int j) { return reverse_[at(i, j)]; }
  double log(int i, int j) const { return log_[at(i, j)]; }
  double phaseReal(int i, int j) const { return phaseReal_[at(i, j)]; }
  double phaseImag(int i, int j) const { return phaseImag_[at(i, j)]; }
  double direct(int i, int j) const { return direct_[at(i, j)]; }
  double reverse(int i, int j) const { return reverse_[at(i, j)]; }

 private:
  static std::size_t at(int i, int j) { return static_cast<std::size_t>(i * stride + j); }
  using Table = std::array<double, stride * stride>;

  Table log_;
  Table phaseReal_;
  Table phaseImag_;
  Table direct_;
  Table reverse_;
};

/// The moments of (E, F) for what is written for either order of the two.
struct MomentsAsTheyAre {
  const LaneMoments& m;
  double log(int i, int j) const { return m.log(i, j); }
  double phaseReal(int i, int j) const { return m.phaseReal(i, j); }
  double phaseImag(int i, int j) const { return m.phaseImag(i, j); }
  double direct(int i, int j) const { return m.direct(i, j); }
  double reverse(int i, int j) const { return m.reverse(i, j); }
};

/// Those of (F, E).
struct MomentsSwapped {
  const LaneMoments& m;
  double log(int i, int j) const { return m.log(j, i); }
  double phaseReal(int i, int j) const { return m.phaseReal(j, i); }
  double phaseImag(int i, int j) const { return m.phaseImag(j, i); }
  double direct(int i, int j) const { return m.reverse(j, i); }
  double reverse(int i, int j) const { return m.direct(j, i); }
};

}  // namespace epafi::reference
