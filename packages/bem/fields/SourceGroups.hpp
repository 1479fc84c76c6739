#pragma once

#include "bem/fields/RunGroups.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <functional>
#include <vector>

namespace epafi::bem {

/// Of SourceGroups.
struct MomentGroup : RunGroup {
  /// M, N and P of eight densities.
  struct Moments {
    ComplexLanes plain{};
    ComplexLanes conjugate{};
    ComplexLanes shifted{};
  };
  /// All k of the first eight densities, then of the next; empty for the whole mesh.
  std::vector<Moments> moments;
  std::size_t terms = 0;  ///< 0 <= k < terms
};

/// Multipole expansions of the far field of many consecutive elements.  With a_k the powers of
/// (y - c)/R for a circle of radius R about c, q = R/(x - c), of a density g
///
///   ∫ g/w = Σ q^(k+1) M_k / R,          M_k = ∫ g a_k,
///   ∫ g/conj(w) = conj Σ q^(k+1) N_k / R,   N_k = ∫ conj(g) a_k,
///   ∫ conj(g) w/conj(w)² = conj (conj(x-c) Σ (k+1) q^(k+2) M_k - Σ (k+1) q^(k+2) P_k) / R²,
///
/// P_k = ∫ g conj(y-c) a_k.  The moments of both halves of a group, moved to the common circle, are
/// those of the whole.
class SourceGroups : public RunGroups<MomentGroup> {
 public:
  using Group = MomentGroup;
  /// Sets the densities at the points of a rule on an element, one point after the other.
  using Densities =
      std::function<void(int element, const Rule& rule, std::vector<Complex>& g)>;

  /// Refers to the runs.
  /// \param count     number of densities
  /// \param smallest  runs that a group has at least; there are no groups of a mesh with less
  /// than four times as many
  /// \param terms     number of polynomials of the densities by element; empty: as the functions of
  /// the elements
  SourceGroups(const ElementRuns& runs, std::size_t count, const Densities& densities,
               int smallest, const std::vector<int>& terms = {});

  /// Terms for an error of 1e-13 of the largest sum at a distance |x - c|.
  static std::size_t termsAt(const Group& group, double distance);
  /// Adds the expansions of the densities ψ, u' of each state at a point far away.
  static void addAt(const Group& group, Complex x, std::vector<FieldSums>& sums);

 private:
  void sumElements(const Densities& densities, const std::vector<int>& terms,
                   Group& group) const;

  std::size_t count_;
};

}  // namespace epafi::bem
