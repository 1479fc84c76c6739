#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/simd/Pack.hpp"

#include <complex>

namespace epafi::bem {

/// Integrals with two polynomials, see TileMoments::setPair.
struct PairSums {
  double log;
  std::complex<double> phase;
  double direct;
  double reverse;
};

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

  /// Zero up to these degrees, all lanes.
  EPAFI_INLINE void clear(int rows, int columns) {
    const Pack zero{};
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j)
        for (Lane* table : {log, along, across, direct, reverse})
          store(table[i * stride + j], zero);
  }

  /// What w/conj(w) gives to a lane, turned by conj(τ²) of F's tangent.
  void setPhase(std::complex<double> turned, int at, int lane) {
    const double constant = at == 0 ? 4 : 0;
    across[at][lane] = 0.5 * (constant - turned.real());
    along[at][lane] = -0.5 * turned.imag();
  }

  /// A pair as integrated over an outer element with d = `rows` and an inner one with `columns`:
  /// sumsOf(i, j) has its log, phase (as in setPhase), direct and reverse.  `transposed`: the
  /// outer one is F.
  template <class SumsOf>
  void setPair(int rows, int columns, bool transposed, int lane, const SumsOf& sumsOf) {
    const int byRow = transposed ? 1 : stride;
    const int byColumn = transposed ? stride : 1;
    Lane* const ofRows = transposed ? reverse : direct;
    Lane* const ofColumns = transposed ? direct : reverse;
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j) {
        const int at = i * byRow + j * byColumn;
        const auto sums = sumsOf(i, j);
        if (i < rows)
          ofRows[at][lane] = sums.direct;
        if (j < columns)
          ofColumns[at][lane] = sums.reverse;
        if (i == rows || j == columns)
          continue;
        log[at][lane] = sums.log;
        setPhase(sums.phase, at, lane);
      }
  }

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
