#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/simd/ComplexPack.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// Densities and slopes of many elements in a row, seen from far away: with a_k the powers
/// of y - c over a circle's radius R about c, q = R/(x - c),
///
///   ∫ g/w = Σ q^(k+1) M_k / R,          M_k = ∫ g a_k,
///   ∫ g/conj(w) = conj Σ q^(k+1) N_k / R,   N_k = ∫ conj(g) a_k,
///   ∫ conj(g) w/conj(w)² = conj (conj(x-c) Σ (k+1) q^(k+2) M_k - Σ (k+1) q^(k+2) P_k) / R²,
///
/// P_k = ∫ g conj(y-c) a_k.  Rows of runs are cut in two down to groups that cost less one
/// by one.
class SourceGroups {
 public:
  /// `fields` of some states, of the first element all, and so on.  Both outlive it.
  SourceGroups(const ElementRuns& runs, const std::vector<LocalField>& fields,
               std::size_t states);

  struct Group {
    int first;  ///< runs, first ... last - 1
    int last;
    int children[2] = {-1, -1};
    Complex centre;
    double radius = 0;
    /// M, N and P of the densities and slopes of four states.
    struct Moments {
      ComplexLanes plain{};
      ComplexLanes conjugate{};
      ComplexLanes shifted{};
    };
    std::vector<Moments>
        moments;            ///< none where runs are treated one by one; of the first four
                            ///< states all k, and so on
    std::size_t terms = 0;  ///< 0 <= k < terms
  };
  /// The first holds all; empty on small meshes.
  const std::vector<Group>& groups() const { return groups_; }

  /// Is a group far from a circle?
  static bool isFar(const Group& group, Complex centre, double radius) {
    return !group.moments.empty() &&
           std::abs(centre - group.centre) - radius >= separation * group.radius;
  }
  /// Adds its sums of each state at a point of a circle that it is far from, to 1e-13 of the
  /// largest.
  static void addAt(const Group& group, Complex x, std::vector<FieldSums>& sums,
                    InstructionSet set = largestInstructionSet());

 private:
  static constexpr double separation = 2.5;
  static constexpr std::size_t statesInLanes = lanes / 2;

  int divide(int first, int last);
  void addElement(int f, Group& group) const;

  const ElementRuns& runs_;
  const std::vector<LocalField>& fields_;
  std::size_t states_;
  std::vector<Group> groups_;
};

}  // namespace epafi::bem
