#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/simd/ComplexPack.hpp"
#include "bem/simd/InstructionSet.hpp"
#include "bem/space/LocalField.hpp"

#include <vector>

namespace epafi::bem {

/// Multipole expansions of the far field of many consecutive elements.  With a_k the powers of
/// (y - c)/R for a circle of radius R about c, q = R/(x - c),
///
///   ∫ g/w = Σ q^(k+1) M_k / R,          M_k = ∫ g a_k,
///   ∫ g/conj(w) = conj Σ q^(k+1) N_k / R,   N_k = ∫ conj(g) a_k,
///   ∫ conj(g) w/conj(w)² = conj (conj(x-c) Σ (k+1) q^(k+2) M_k - Σ (k+1) q^(k+2) P_k) / R²,
///
/// P_k = ∫ g conj(y-c) a_k.  Groups of consecutive runs are halved until summation over their
/// elements is cheaper than an expansion.
class SourceGroups {
 public:
  /// `fields`: elements x states, states contiguous.  Refers to runs and fields.
  SourceGroups(const ElementRuns& runs, const std::vector<LocalField>& fields,
               std::size_t states);

  struct Group {
    int first;  ///< runs first ... last - 1
    int last;
    int children[2] = {-1, -1};
    Complex centre;
    double radius = 0;
    /// M, N and P of densities and slopes of four states.
    struct Moments {
      ComplexLanes plain{};
      ComplexLanes conjugate{};
      ComplexLanes shifted{};
    };
    std::vector<Moments>
        moments;            ///< empty for groups without expansion; all k of the first
                            ///< four states, then of the next
    std::size_t terms = 0;  ///< 0 <= k < terms
  };
  /// groups()[0] is the whole mesh; empty on small meshes.
  const std::vector<Group>& groups() const { return groups_; }

  /// Has the group an expansion that is valid in this circle?
  static bool isFar(const Group& group, Complex centre, double radius) {
    return !group.moments.empty() &&
           std::abs(centre - group.centre) - radius >= separation * group.radius;
  }
  /// Adds the expansion of each state at a point of a circle with isFar; error 1e-13 of the
  /// largest sum.
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
