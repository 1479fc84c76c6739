#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/simd/Pack.hpp"

#include <complex>

namespace epafi::bem {

/// All that V, K and W need of a trial element E and eight test elements F, one in each
/// lane: double integrals of Legendre polynomials, w = x - y, x on E, y on F, both mapped
/// to [-1, 1].
///
///   log(i,j)     = ∫∫ P_i(x) P_j(y) log|w|                   i < d_E, j < d_F
///   along(i,j)   = ∫∫ P_i(x) P_j(y) (w·n_F)(w·τ_F)/|w|²      i < d_E, j < d_F
///   across(i,j)  = ∫∫ P_i(x) P_j(y) (w·n_F)²/|w|²            i < d_E, j < d_F
///   direct(i,j)  = ∫∫ P_i(x) P_j(y) (w·n_F)/|w|² h_F/2       i < d_E, j <= d_F
///   reverse(i,j) = ∫∫ P_i(x) P_j(y) (-w·n_E)/|w|² h_E/2      i <= d_E, j < d_F
///
/// d: the number of density functions, at least the degree.  Where F is an arc n_F and τ_F
/// are those of its middle in `along` and `across`, in `direct` and `reverse` normals turn.
struct TileMoments {
  static constexpr int stride = largestDegree + 2;
  using Lane = double[lanes];
  alignas(64) Lane log[stride * stride];
  alignas(64) Lane along[stride * stride];
  alignas(64) Lane across[stride * stride];
  alignas(64) Lane direct[stride * stride];
  alignas(64) Lane reverse[stride * stride];

  /// ∫∫ P_i P_j w/conj(w) of a lane, where F has this tangent:
  /// w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²).
  std::complex<double> phase(int i, int j, int lane, std::complex<double> tangent) const {
    const int at = i * stride + j;
    const double constant = at == 0 ? 4 : 0;
    return tangent * tangent *
           std::complex<double>(constant - 2 * across[at][lane], -2 * along[at][lane]);
  }
};

}  // namespace epafi::bem
