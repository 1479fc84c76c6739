#pragma once

#include "bem/basis/Legendre.hpp"
#include "bem/moments/ElementRuns.hpp"

#include <complex>

namespace epafi::bem {

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
///
/// All operators are assembled from them.  Large: use one object per thread.
class Tile {  // NOLINT(cppcoreguidelines-pro-type-member-init): clear() sets what is used
 public:
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

  /// Integrals of the five kernels times P_j over y at points x.
  struct alignas(64) Inner {
    Pack log;
    Pack along;
    Pack across;
    Pack direct;
    Pack reverse;
  };
  /// Adds them for all P_i; Weight: double or Pack.
  /// \param weight P_i(x) times weights of a rule
  template <class Weight>
  EPAFI_INLINE void addInner(const Inner& inner, int rows, int columns, int j,
                             const Weight* weight) {
    for (int i = 0; i < rows; ++i)
      add(direct[i * stride + j], inner.direct * weight[i]);
    if (j == columns)
      return;
    for (int i = 0; i < rows; ++i) {
      const int at = i * stride + j;
      add(log[at], inner.log * weight[i]);
      add(along[at], inner.along * weight[i]);
      add(across[at], inner.across * weight[i]);
    }
    for (int i = 0; i <= rows; ++i)
      add(reverse[i * stride + j], inner.reverse * weight[i]);
  }

  /// ∫∫ P_i P_j w/conj(w) of a lane; `tangent`: τ_F:
  /// w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²).
  std::complex<double> phase(int i, int j, int lane, std::complex<double> tangent) const {
    const int at = i * stride + j;
    const double constant = at == 0 ? 4 : 0;
    return tangent * tangent *
           std::complex<double>(constant - 2 * across[at][lane], -2 * along[at][lane]);
  }

  /// Computes the moments of a trial element with the wanted elements of run r, near or far.  The
  /// quadrature of a pair depends on the other elements of its tile: equal results need equal
  /// tiles.  Moments of elements that are not wanted are finite and meaningless.
  /// Refers to the runs.
  void evaluate(const ElementRuns& runs, int trial, int r, const ElementRange& wanted);
  int trial() const { return trial_; }
  const ElementLanes& run() const { return *run_; }
  bool isWanted(int lane) const { return wanted_.contain(run_->first + lane); }
  bool isFar(int lane) const { return far_[lane]; }

 private:
  int trial_ = 0;
  const ElementLanes* run_ = nullptr;
  ElementRange wanted_;
  bool far_[lanes] = {};
};

}  // namespace epafi::bem
