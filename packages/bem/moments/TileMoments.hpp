#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/simd/Pack.hpp"

#include <complex>

namespace epafi::bem {

/// Double integrals with two polynomials, see TileMoments::setPair.
struct PairSums {
  double log;
  std::complex<double> phase;
  double direct;
  double reverse;
};

/// Moments for V, K and W of a trial element E and eight test elements F, one in each lane:
/// double integrals of Legendre polynomials, w = x - y, x on E, y on F, both mapped to
/// [-1, 1].
///
///   log(i,j)     = ∫∫ P_i(x) P_j(y) log|w|                   i < d_E, j < d_F
///   along(i,j)   = ∫∫ P_i(x) P_j(y) (w·n_F)(w·τ_F)/|w|²      i < d_E, j < d_F
///   across(i,j)  = ∫∫ P_i(x) P_j(y) (w·n_F)²/|w|²            i < d_E, j < d_F
///   direct(i,j)  = ∫∫ P_i(x) P_j(y) (w·n_F)/|w|² h_F/2       i < d_E, j <= d_F
///   reverse(i,j) = ∫∫ P_i(x) P_j(y) (-w·n_E)/|w|² h_E/2      i <= d_E, j < d_F
///
/// d: number of Legendre polynomials of the densities, at least the degree.  On an arc F,
/// `along` and `across` use n_F and τ_F at its midpoint, `direct` and `reverse` at each point.
struct TileMoments {
  static constexpr int stride = largestDegree + 2;
  using Lane = double[lanes];
  alignas(64) Lane log[stride * stride];
  alignas(64) Lane along[stride * stride];
  alignas(64) Lane across[stride * stride];
  alignas(64) Lane direct[stride * stride];
  alignas(64) Lane reverse[stride * stride];

  /// Sets moments up to these degrees to zero in all lanes.
  EPAFI_INLINE void clear(int rows, int columns) {
    const Pack zero{};
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j)
        for (Lane* table : {log, along, across, direct, reverse})
          store(table[i * stride + j], zero);
  }

  /// Sets `along` and `across` of a lane from `turned` = conj(τ_F²) ∫∫ P_i P_j w/conj(w).
  void setPhase(std::complex<double> turned, int at, int lane) {
    const double constant = at == 0 ? 4 : 0;
    across[at][lane] = 0.5 * (constant - turned.real());
    along[at][lane] = -0.5 * turned.imag();
  }

  /// Sets a pair that was integrated over an outer element, d = rows, and an inner one, d =
  /// columns: sumsOf(i, j) returns PairSums, phase as in setPhase.
  /// \param transposed the outer element is F
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

  /// ∫∫ P_i P_j w/conj(w) of a lane; `tangent`: τ_F:
  /// w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²).
  std::complex<double> phase(int i, int j, int lane, std::complex<double> tangent) const {
    const int at = i * stride + j;
    const double constant = at == 0 ? 4 : 0;
    return tangent * tangent *
           std::complex<double>(constant - 2 * across[at][lane], -2 * along[at][lane]);
  }
};

}  // namespace epafi::bem
